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

// Predicts the orientation of a body.
template <typename Policy>
concept RotationPolicy = requires(std::span<const MotionState> states, double time_s) {
  { Policy::Rotation(states, time_s) } -> std::same_as<Eigen::Quaterniond>;
};

// Policy: the body keeps the angular velocity between its last two states.
struct ConstantAngularVelocity {
  static Eigen::Quaterniond Rotation(std::span<const MotionState> states, double time_s);
};
// Policy: the body does not turn (the paper's prediction moves points only by their cluster's
// velocity).
struct HeldRotation {
  static Eigen::Quaterniond Rotation(std::span<const MotionState> states, double time_s);
};

// How a body moves, as assumed by its prediction and by the solver.
template <typename Policy>
concept BodyMotionPolicy = MotionPriorPolicy<Policy> && RotationPolicy<Policy>;

// Policy: white noise on the acceleration and on the angular acceleration (METHOD.md 8.2, 8.3).
struct WhiteNoiseMotion : WhiteNoiseOnAcceleration, ConstantAngularVelocity {};
// Policy: white noise on the acceleration, with the paper's density per frame; predicted bodies do
// not turn.
struct FrameNoiseMotion : WhiteNoiseOnAccelerationFrameUnits, HeldRotation {};
// Policies: without the prior on orientations, without that on positions, and without any.
struct TranslationNoiseMotion : WhiteNoiseOnTranslation, ConstantAngularVelocity {};
struct TurnNoiseMotion : WithTurnPrior<NoMotionPrior>, ConstantAngularVelocity {};
struct FreeMotion : NoMotionPrior, ConstantAngularVelocity {};

// Predicts the position as t + v dt, with the covariance q dt^3 / 3 I + dt^2 Sigma_v: the
// uncertainty added over dt seconds to that of the last state's position. Throws Error if time_s is
// not after the last state.
PredictedMotion ExtrapolateTranslation(const MotionState& last, double time_s,
                                       double power_density_m2_s3,
                                       const Eigen::Matrix3d& velocity_covariance_m2_s2);

// Predicts the body's motion at time_s, which must be after the last of its states (at least one;
// oldest first, times increasing).
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
