// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/association/box_association.h"
#include "core/association/gated_matching.h"
#include "core/clustering/dense_crf.h"
#include "core/clustering/label_confidence.h"
#include "core/clustering/unary_terms.h"
#include "core/clusters/box_rematch.h"
#include "core/clusters/identity.h"
#include "core/estimation/motion_extrapolation.h"
#include "core/estimation/window_policies.h"
#include "core/odometry/detection_policies.h"
#include "core/solvers/motion_prior.h"

namespace cvo {

// In what variants differ, and what each axis asks of its policies.
template <DetectionPolicy, LandmarkAssociationPolicy, BoxWeightsPolicy, BoxRematchPolicy,
          RotationPolicy, IdentityPolicy, UnaryTerm /* box */, UnaryTerm /* affinity */,
          UnaryTerm /* motion */, PairwisePolicy, ConfidencePolicy, MotionPriorPolicy,
          MarginalizationPolicy, GaugePolicy, PromotionPolicy, CalibrationPolicy>
struct Axes {};

// A variant names its policies; one that lacks an axis or a policy that does not fit its axis does
// not compile.
template <typename V>
using AxesOf =
    Axes<typename V::Detections, typename V::LandmarkAssociation, typename V::BoxWeights,
         typename V::BoxRematch, typename V::Rotation, typename V::Identity, typename V::BoxTerm,
         typename V::AffinityTerm, typename V::MotionTerm, typename V::Pairwise,
         typename V::Confidence, typename V::MotionPrior, typename V::MarginalizationRule,
         typename V::Gauge, typename V::SpatialTrack, typename V::Calibration>;

template <typename V>
concept EstimatorVariant = requires {
  typename AxesOf<V>;
};

}  // namespace cvo
