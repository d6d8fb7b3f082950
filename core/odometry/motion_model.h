// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "core/geometry/rigid_transform.h"

namespace cvo {

// Constant-velocity model of the camera in its own frame, rad/s and m/s, from the last two poses.
class MotionModel {
 public:
  // Sets the pose of the camera at a time; timestamps must increase.
  void Update(std::int64_t timestamp_ns, const RigidTransform& world_from_camera);
  // Predicts the pose of the camera; the identity before the first update.
  RigidTransform Predict(std::int64_t timestamp_ns) const;
  bool HasVelocity() const { return updates_ > 1; }

 private:
  int updates_ = 0;
  std::int64_t timestamp_ns_ = 0;
  RigidTransform world_from_camera_;
  // [rotation, translation] of previous_camera_from_camera, per second.
  Vector6d velocity_ = Vector6d::Zero();
};

}  // namespace cvo
