// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <concepts>
#include <span>

#include "core/base/error.h"
#include "core/geometry/rigid_transform.h"
#include "core/solvers/motion_prior.h"

namespace cvo {

struct MotionState {
  double time_s = 0.0;
  RigidTransform world_from_object;
  Eigen::Vector3d velocity_m_s = Eigen::Vector3d::Zero();  // of the object's origin, in world
};

struct PredictedMotion {
  MotionState state;
  double power_density_m2_s3 = 0.0;  // q, for the step
};

// The variance, per axis, that q and a velocity of this standard deviation add to a position in
// dt_s: q dt^3 / 3 + dt^2 s_v^2 (METHOD.md 4.2).
inline double AddedVariance(double power_density_m2_s3, double speed_deviation_m_s, double dt_s) {
  return power_density_m2_s3 * dt_s * dt_s * dt_s / 3.0 +
         dt_s * dt_s * (speed_deviation_m_s * speed_deviation_m_s);
}

// Predicts the state of a body after its last one; the states are as for Extrapolate.
template <typename Policy>
concept PathPolicy = requires(std::span<const MotionState> states, double time_s) {
  { Policy::StateAt(states, time_s) } -> std::same_as<MotionState>;
};

// Policy: the body keeps its velocity and the angular velocity between its last two states. Over a
// gap, the point that moved most evenly so far continues its line, and the body keeps its mean
// angular velocity (METHOD.md 4.2).
struct ConstantMotion {
  static MotionState StateAt(std::span<const MotionState> states, double time_s);
};
// Policy: the body keeps its velocity and does not turn (the paper's prediction moves points only
// by their cluster's velocity).
struct HeldRotation {
  static MotionState StateAt(std::span<const MotionState> states, double time_s);
};

// How a body moves, as assumed by its prediction and by the solver.
template <typename Policy>
concept BodyMotionPolicy = MotionPriorPolicy<Policy> && PathPolicy<Policy>;

// Policy: white noise on the acceleration and on the angular acceleration (METHOD.md 8.2, 8.3).
struct WhiteNoiseMotion : WhiteNoiseOnAcceleration, ConstantMotion {};
// Policy: white noise on the acceleration, with the paper's density per frame; predicted bodies do
// not turn.
struct FrameNoiseMotion : WhiteNoiseOnAccelerationFrameUnits, HeldRotation {};
// Policies: without the prior on orientations, without that on positions, and without any.
struct TranslationNoiseMotion : WhiteNoiseOnTranslation, ConstantMotion {};
struct TurnNoiseMotion : WithTurnPrior<NoMotionPrior>, ConstantMotion {};
struct FreeMotion : NoMotionPrior, ConstantMotion {};

// Predicts the body's motion at time_s. Throws Error if time_s is not after the last of its states
// (at least one; oldest first, times increasing).
template <MotionPriorPolicy MotionPrior, PathPolicy Path>
PredictedMotion Extrapolate(const MotionPriorOptions& options, std::span<const MotionState> states,
                            double time_s) {
  const double dt = time_s - states.back().time_s;
  Require(dt > 0.0, "Extrapolate: time_s must be after the last state");
  return {Path::StateAt(states, time_s), MotionPrior::PowerDensity(options, dt)};
}

}  // namespace cvo
