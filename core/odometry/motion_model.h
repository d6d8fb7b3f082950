// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "core/geometry/rigid_transform.h"

namespace cvo {

// The camera at constant velocity in its own frame: rad/s and m/s from the last two poses.
class MotionModel {
 public:
  // The camera was at `world_from_camera`; timestamps must increase.
  void Update(std::int64_t timestamp_ns, const RigidTransform& world_from_camera);
  // Identity before the first update.
  RigidTransform Predict(std::int64_t timestamp_ns) const;
  bool HasVelocity() const { return updates_ > 1; }

 private:
  int updates_ = 0;
  std::int64_t timestamp_ns_ = 0;
  RigidTransform world_from_camera_;
  Vector6d velocity_ =
      Vector6d::Zero();  // [rotation, translation] of camera_from_camera per second
};

}  // namespace cvo
