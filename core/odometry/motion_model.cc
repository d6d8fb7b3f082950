// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/odometry/motion_model.h"

namespace cvo {

void MotionModel::Update(std::int64_t timestamp_ns, const RigidTransform& world_from_camera) {
  const RigidTransform previous = world_from_camera_;
  interval_s_ = 1e-9 * static_cast<double>(timestamp_ns - timestamp_ns_);
  timestamp_ns_ = timestamp_ns;
  world_from_camera_ = world_from_camera;
  if (updates_++ > 0) SetVelocity(previous);
}

void MotionModel::Correct(const RigidTransform& previous, const RigidTransform& world_from_camera) {
  world_from_camera_ = world_from_camera;
  SetVelocity(previous);
}

void MotionModel::SetVelocity(const RigidTransform& previous) {
  const RigidTransform motion = previous.Inverse() * world_from_camera_;
  velocity_ << LogSo3(Eigen::Quaterniond(motion.rotation())), motion.translation();
  velocity_ /= interval_s_;
}

RigidTransform MotionModel::Predict(std::int64_t timestamp_ns) const {
  const double elapsed_s = 1e-9 * static_cast<double>(timestamp_ns - timestamp_ns_);
  const Vector6d motion = elapsed_s * velocity_;
  return world_from_camera_ *
         RigidTransform(ExpSo3(motion.head<3>()), Eigen::Vector3d(motion.tail<3>()));
}

}  // namespace cvo
