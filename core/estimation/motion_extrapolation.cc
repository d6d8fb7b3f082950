// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/estimation/motion_extrapolation.h"

#include <Eigen/Cholesky>

namespace cvo {

namespace {

// A prediction over more than this many mean intervals of the states is over a gap.
constexpr double kGap = 1.5;
// Fewer states hardly tell an even motion from an uneven one.
constexpr std::size_t kLeastStates = 4;
// Deviation of a path from a line at constant speed, as a fraction of the deviation of the point
// from the origin.
constexpr double kUnevenness = 0.2;

// Rotation vector from the orientation `before` to `after`, in world.
Eigen::Vector3d Turn(const MotionState& before, const MotionState& after) {
  return LogSo3(Eigen::Quaterniond(after.world_from_object.rotation() *
                                   before.world_from_object.rotation().conjugate()));
}

// A point of a body.
struct BodyPoint {
  Eigen::Vector3d p_in_object;
  Eigen::Vector3d p_in_world;  // at the last state
  Eigen::Vector3d velocity_m_s;
};

BodyPoint OriginOf(const MotionState& last) {
  return {Eigen::Vector3d::Zero(), last.world_from_object.translation(), last.velocity_m_s};
}

// The state of a body whose point keeps its velocity, at a time after the last state.
MotionState Moved(const MotionState& last, double time_s, const BodyPoint& point,
                  const Eigen::Vector3d& turn_rad_s) {
  const double dt = time_s - last.time_s;
  const Eigen::Quaterniond rotation(ExpSo3(turn_rad_s * dt) * last.world_from_object.rotation());
  const Eigen::Vector3d lever = rotation * point.p_in_object;
  const Eigen::Vector3d p_in_world = point.p_in_world + point.velocity_m_s * dt;
  return {time_s, RigidTransform(rotation, Eigen::Vector3d(p_in_world - lever)),
          point.velocity_m_s - turn_rad_s.cross(lever)};
}

// Returns the point whose path comes closest to a line at constant speed; of a body that does not
// turn, the origin. The line is that of least squares for any point, so only the point is unknown.
// Its place is that on the line.
BodyPoint MostEvenPoint(std::span<const MotionState> states) {
  const auto n = static_cast<double>(states.size());
  double mean_s = 0.0;
  Eigen::Matrix3d mean_R = Eigen::Matrix3d::Zero();
  Eigen::Vector3d mean_t = Eigen::Vector3d::Zero();
  for (const MotionState& state : states) {
    mean_s += state.time_s / n;
    mean_R += state.world_from_object.RotationMatrix() / n;
    mean_t += state.world_from_object.translation() / n;
  }
  double squares_s2 = 0.0;
  Eigen::Matrix3d slope_R = Eigen::Matrix3d::Zero();
  Eigen::Vector3d slope_t = Eigen::Vector3d::Zero();
  for (const MotionState& state : states) {
    const double s = state.time_s - mean_s;
    squares_s2 += s * s;
    slope_R += s * state.world_from_object.RotationMatrix();
    slope_t += s * state.world_from_object.translation();
  }
  slope_R /= squares_s2;
  slope_t /= squares_s2;
  Eigen::Matrix3d H = kUnevenness * kUnevenness * Eigen::Matrix3d::Identity();
  Eigen::Vector3d g = Eigen::Vector3d::Zero();
  for (const MotionState& state : states) {
    const double s = state.time_s - mean_s;
    const Eigen::Matrix3d J = state.world_from_object.RotationMatrix() - mean_R - s * slope_R;
    const Eigen::Vector3d r = state.world_from_object.translation() - mean_t - s * slope_t;
    H += J.transpose() * J;
    g += J.transpose() * r;
  }
  const Eigen::Vector3d p = -H.llt().solve(g);
  const Eigen::Vector3d velocity_m_s = slope_t + slope_R * p;
  const double last_s = states.back().time_s - mean_s;
  return {p, mean_t + mean_R * p + last_s * velocity_m_s, velocity_m_s};
}

}  // namespace

MotionState ConstantMotion::StateAt(std::span<const MotionState> states, double time_s) {
  const MotionState& last = states.back();
  if (states.size() < 2) return HeldRotation::StateAt(states, time_s);
  const double seen_s = last.time_s - states.front().time_s;
  const bool is_gap =
      (time_s - last.time_s) * static_cast<double>(states.size() - 1) > kGap * seen_s;
  if (!is_gap || states.size() < kLeastStates) {
    const MotionState& before = states[states.size() - 2];
    return Moved(last, time_s, OriginOf(last), Turn(before, last) / (last.time_s - before.time_s));
  }
  Eigen::Vector3d turn = Eigen::Vector3d::Zero();
  for (std::size_t i = 1; i < states.size(); ++i) turn += Turn(states[i - 1], states[i]);
  return Moved(last, time_s, MostEvenPoint(states), turn / seen_s);
}

MotionState HeldRotation::StateAt(std::span<const MotionState> states, double time_s) {
  const MotionState& last = states.back();
  return Moved(last, time_s, OriginOf(last), Eigen::Vector3d::Zero());
}

}  // namespace cvo
