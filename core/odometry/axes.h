// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/association/box_association.h"
#include "core/association/matching.h"
#include "core/clustering/dense_crf.h"
#include "core/clustering/unary_terms.h"
#include "core/clusters/cluster_association.h"
#include "core/clusters/cluster_map.h"
#include "core/clusters/identity.h"
#include "core/estimation/double_track.h"
#include "core/estimation/motion_extrapolation.h"
#include "core/labelling/cluster_labels.h"
#include "core/labelling/landmark_update.h"
#include "core/odometry/cluster_update.h"
#include "core/solvers/motion_prior.h"
#include "core/solvers/schur_solver.h"

namespace cvo {

template <typename Policy>
concept NewBodyAndOriginPolicy = NewBodyPolicy<Policy> && BirthOriginPolicy<Policy>;

// The axes along which variants differ, with the concept that each one requires of its policy. Two
// variants with the same axes are the same type of estimator, whatever their options.
template <DetectionPolicy D, LandmarkAssociationPolicy LA, BoxPolicy B, BoxRematchPolicy BR,
          IdentityPolicy I, UnaryTerm BT, UnaryTerm AT, UnaryTerm MT, NewBodyAndOriginPolicy NB,
          PairwisePolicy P, ConfidencePolicy C, BodyMotionPolicy BM, OutlierPolicy O, FramePolicy F,
          SolverPolicy S>
struct Axes {
  using Detections = D;
  using LandmarkAssociation = LA;
  using Boxes = B;
  using BoxRematch = BR;
  using Identity = I;
  using BoxTerm = BT;
  using AffinityTerm = AT;
  using MotionTerm = MT;
  using NewBody = NB;
  using Pairwise = P;
  using Confidence = C;
  using BodyMotion = BM;
  using Outliers = O;
  using Frames = F;
  using Solver = S;
};

// Collects the policies that a variant names. A variant that lacks an axis, or names a policy that
// does not satisfy the concept of its axis, does not compile.
template <typename V>
using AxesOf = Axes<typename V::Detections, typename V::LandmarkAssociation, typename V::Boxes,
                    typename V::BoxRematch, typename V::Identity, typename V::BoxTerm,
                    typename V::AffinityTerm, typename V::MotionTerm, typename V::NewBody,
                    typename V::Pairwise, typename V::Confidence, typename V::BodyMotion,
                    typename V::Outliers, typename V::Frames, typename V::Solver>;

template <typename V>
concept EstimatorVariant = requires {
  typename AxesOf<V>;
};

}  // namespace cvo
