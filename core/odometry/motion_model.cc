// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/odometry/motion_model.h"

namespace cvo {

void MotionModel::Update(std::int64_t timestamp_ns, const RigidTransform& world_from_camera) {
  if (updates_++ > 0) {
    const double interval_s = 1e-9 * static_cast<double>(timestamp_ns - timestamp_ns_);
    const RigidTransform motion = world_from_camera_.Inverse() * world_from_camera;
    velocity_ << LogSo3(Eigen::Quaterniond(motion.rotation())), motion.translation();
    velocity_ /= interval_s;
  }
  timestamp_ns_ = timestamp_ns;
  world_from_camera_ = world_from_camera;
}

RigidTransform MotionModel::Predict(std::int64_t timestamp_ns) const {
  const double elapsed_s = 1e-9 * static_cast<double>(timestamp_ns - timestamp_ns_);
  const Vector6d motion = elapsed_s * velocity_;
  return world_from_camera_ *
         RigidTransform(ExpSo3(motion.head<3>()), Eigen::Vector3d(motion.tail<3>()));
}

}  // namespace cvo
