// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <tuple>

#include "core/base/task_pool.h"
#include "core/clusters/cluster_association.h"
#include "core/clusters/cluster_optimization.h"
#include "core/estimation/double_track.h"
#include "core/estimation/motion_extrapolation.h"
#include "core/interface/frame.h"
#include "core/labelling/cluster_labels.h"
#include "core/odometry/cluster_update.h"

namespace cvo {

// The axes along which variants differ. Two variants with the same axes are the same estimator,
// whatever their options. A variant that lacks an axis does not compile.
template <typename V>
using AxesOf = std::tuple<typename V::Detections, typename V::LandmarkAssociation,
                          typename V::Boxes, typename V::BoxRematch, typename V::BoxTerm,
                          typename V::AffinityTerm, typename V::MotionTerm, typename V::NewBody,
                          typename V::Pairwise, typename V::Confidence, typename V::BodyMotion,
                          typename V::Outliers, typename V::Frames, typename V::Solver>;

// The functions of a variant's policies, in the order in which a frame needs them.
struct Steps {
  ShownBodies (*show)(StereoFrame&);
  AssociationSteps association;
  Extrapolation* extrapolate;
  LabelSteps labels;
  void (*advance)(const Options&, const WindowFrame&, Window&);  // DoubleTrack
  EnergySteps energy;
};

// A variant that names a policy which lacks a function of its axis does not compile.
template <typename V>
constexpr Steps StepsOf() {
  using Boxes = typename V::Boxes;
  using Motion = typename V::BodyMotion;
  return {
      .show = &V::Detections::Show,
      .association = {&V::LandmarkAssociation::Find, &Boxes::Compute, &Boxes::Cost,
                      Boxes::kComparesClasses, &V::BoxRematch::Rematch},
      .extrapolate = &Extrapolate<Motion, Motion>,
      .labels =
          {&ComputeUnaries<typename V::BoxTerm, typename V::AffinityTerm, typename V::MotionTerm>,
           &InferDenseCrf<typename V::Pairwise>, &V::Confidence::Update, &V::NewBody::Candidates},
      .advance =
          [](const Options& options, const WindowFrame& entering, Window& window) {
            DoubleTrack<typename V::Frames>(options.window, options.NoiseOfFeatures())
                .Advance(entering, window);
          },
      .energy = {&StepsOfPrior<Motion>, &V::Outliers::Gate, &V::Solver::Solve, &V::Solver::Solve}};
}

// Makes the estimator with these steps. `pool` must outlive it.
std::unique_ptr<Odometry> MakeOdometry(const Steps& steps, const OdometrySetup& setup,
                                       TaskPool& pool);

}  // namespace cvo
