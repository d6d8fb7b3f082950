// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/estimation/motion_extrapolation.h"

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

}  // namespace cvo
