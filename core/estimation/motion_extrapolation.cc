// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/estimation/motion_extrapolation.h"

#include "core/base/error.h"

namespace cvo {

Eigen::Quaterniond ConstantAngularVelocity::Rotation(std::span<const MotionState> states,
                                                     double time_s) {
  const MotionState& last = states.back();
  const Eigen::Quaterniond rotation(last.world_from_object.rotation());
  if (states.size() < 2) return rotation;
  const MotionState& before = states[states.size() - 2];
  const Eigen::Vector3d turn =
      LogSo3(Eigen::Quaterniond(before.world_from_object.rotation().conjugate() * rotation));
  return rotation * ExpSo3(turn * ((time_s - last.time_s) / (last.time_s - before.time_s)));
}

Eigen::Quaterniond HeldRotation::Rotation(std::span<const MotionState> states, double) {
  return Eigen::Quaterniond(states.back().world_from_object.rotation());
}

PredictedMotion ExtrapolateTranslation(const MotionState& last, double time_s,
                                       double power_density_m2_s3,
                                       const Eigen::Matrix3d& velocity_covariance_m2_s2) {
  const double dt = time_s - last.time_s;
  Require(dt > 0.0, "ExtrapolateTranslation: time_s must be after the last state");
  PredictedMotion predicted;
  predicted.world_from_object = RigidTransform(
      Eigen::Quaterniond(last.world_from_object.rotation()),
      Eigen::Vector3d(last.world_from_object.translation() + last.velocity_m_s * dt));
  predicted.translation_covariance_m2 =
      power_density_m2_s3 * dt * dt * dt / 3.0 * Eigen::Matrix3d::Identity() +
      dt * dt * velocity_covariance_m2_s2;
  return predicted;
}

}  // namespace cvo
