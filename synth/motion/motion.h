// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <memory>

#include "core/geometry/rigid_transform.h"

namespace cvo::synth {

// Pose and velocity of something at one instant. In the scene's world, z is up; lengths in metres.
struct MotionState {
  RigidTransform world_from_body;
  Eigen::Vector3d velocity_in_world = Eigen::Vector3d::Zero();          // of the body's origin, m/s
  Eigen::Vector3d angular_velocity_in_world = Eigen::Vector3d::Zero();  // rad/s
};

// A twice-differentiable path. The state depends only on the time, not on earlier calls.
class Motion {
 public:
  virtual ~Motion() = default;
  virtual MotionState At(double time_s) const = 0;
};

}  // namespace cvo::synth
