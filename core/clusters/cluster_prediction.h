// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "core/association/gated_matching.h"
#include "core/clusters/frame_view.h"
#include "core/estimation/cluster.h"
#include "core/estimation/motion_extrapolation.h"
#include "core/estimation/window.h"

namespace cvo {

// A cluster extrapolated to the current frame (section 3.1 of the paper).
struct PredictedCluster {
  RigidTransform world_from_object;
  Eigen::Vector3d velocity_m_s = Eigen::Vector3d::Zero();
  double translation_variance_m2 = 0.0;  // of its origin, per axis
  double rotation_variance_rad2 = 0.0;
};

// Returns the cluster's last two states, or its only one, with times relative to origin_ns.
std::vector<MotionState> LastStates(const Cluster& cluster, std::int64_t origin_ns);
// Returns the prediction with mean `extrapolated`, dt_s after the latest state, and its variances.
PredictedCluster WithUncertainty(const Cluster& cluster, const PredictedMotion& extrapolated,
                                 double dt_s, const ClusterOptions& options);
// Variances of the cluster's velocity (m^2/s^2) and angular velocity (rad^2/s^2), per axis.
double SpeedVariance(const Cluster& cluster, const ClusterOptions& options);
double TurnVariance(const Cluster& cluster, const ClusterOptions& options);

template <MotionPriorPolicy MotionPrior, RotationPolicy Rotation>
PredictedCluster PredictCluster(const Cluster& cluster, std::int64_t timestamp_ns,
                                const MotionPriorOptions& motion, const ClusterOptions& options) {
  const std::int64_t origin_ns = cluster.Latest().timestamp_ns;
  const double dt_s = SecondsBetween(origin_ns, timestamp_ns);
  const Eigen::Matrix3d speed = SpeedVariance(cluster, options) * Eigen::Matrix3d::Identity();
  return WithUncertainty(
      cluster,
      Extrapolate<MotionPrior, Rotation>(motion, LastStates(cluster, origin_ns), dt_s, speed), dt_s,
      options);
}

// Predicts any cluster at one fixed time.
using ClusterPredictor = std::function<PredictedCluster(const Cluster&)>;

// Returns a predictor for timestamp_ns. `motion` and `options` must outlive it.
template <MotionPriorPolicy MotionPrior, RotationPolicy Rotation>
ClusterPredictor PredictorAt(std::int64_t timestamp_ns, const MotionPriorOptions& motion,
                             const ClusterOptions& options) {
  return [timestamp_ns, &motion, &options](const Cluster& cluster) {
    return PredictCluster<MotionPrior, Rotation>(cluster, timestamp_ns, motion, options);
  };
}

// Predicts how the current camera sees a landmark of the cluster. Empty if the landmark is behind
// the camera, outside the image or on the far side of the body.
std::optional<PredictedLandmark> PredictLandmark(const ClusterSearch& search,
                                                 const PredictedCluster& predicted,
                                                 const Landmark& landmark);

}  // namespace cvo
