// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <concepts>
#include <span>

#include "core/geometry/rigid_transform.h"
#include "core/solvers/motion_prior.h"

namespace cvo {

struct MotionState {
  double time_s = 0.0;
  RigidTransform world_from_object;
  Eigen::Vector3d velocity_m_s = Eigen::Vector3d::Zero();  // of the object's origin, in world
};

struct PredictedMotion {
  RigidTransform world_from_object;
  Eigen::Matrix3d translation_covariance_m2 = Eigen::Matrix3d::Zero();  // in world
};

// How a body turns on.
template <typename Policy>
concept RotationPolicy = requires(std::span<const MotionState> states, double time_s) {
  { Policy::Rotation(states, time_s) } -> std::same_as<Eigen::Quaterniond>;
};

// Policy: as it did between its last two states.
struct ConstantAngularVelocity {
  static Eigen::Quaterniond Rotation(std::span<const MotionState> states, double time_s);
};
// Policy: not at all (the paper's prediction moves points by their cluster's velocity only).
struct HeldRotation {
  static Eigen::Quaterniond Rotation(std::span<const MotionState> states, double time_s);
};

// t + v dt and its covariance q dt^3 / 3 I + dt^2 Sigma_v: what dt seconds add to the uncertainty
// of the last state's position. Throws Error where time_s is not after the last state.
PredictedMotion ExtrapolateTranslation(const MotionState& last, double time_s,
                                       double power_density_m2_s3,
                                       const Eigen::Matrix3d& velocity_covariance_m2_s2);

// A motion with white noise on its acceleration, dt_s long, whose velocity is measured at both ends
// (METHOD.md 6.5): its mean velocity is before + later_share (after - before); `variance` is that
// of the way, dt_s times it.
struct BridgedMotion {
  double later_share = 0.0;
  double variance = 0.0;  // m^2 or rad^2
};
BridgedMotion BridgeMotion(double dt_s, double power_density, double variance_before,
                           double variance_after);

// The body at time_s, after the last of its states (at least one; oldest first, times increasing).
template <MotionPriorPolicy MotionPrior, RotationPolicy RotationModel>
PredictedMotion Extrapolate(const MotionPriorOptions& options, std::span<const MotionState> states,
                            double time_s, const Eigen::Matrix3d& velocity_covariance_m2_s2) {
  const MotionState& last = states.back();
  PredictedMotion predicted =
      ExtrapolateTranslation(last, time_s, MotionPrior::PowerDensity(options, time_s - last.time_s),
                             velocity_covariance_m2_s2);
  predicted.world_from_object =
      RigidTransform(RotationModel::Rotation(states, time_s),
                     Eigen::Vector3d(predicted.world_from_object.translation()));
  return predicted;
}

}  // namespace cvo
