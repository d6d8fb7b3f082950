// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/bodies/body_direction.h"

#include <Eigen/Geometry>
#include <cmath>

namespace cvo {

Eigen::Vector3d Levelled(const Eigen::Vector3d& direction, const Eigen::Vector3d& down) {
  const Eigen::Vector3d level = direction - down * down.dot(direction);
  constexpr double kVertical = 1e-6;
  if (level.norm() > kVertical * direction.norm()) return level.normalized();
  return down.unitOrthogonal();
}

Eigen::Vector3d TurnedBy(const RigidTransform& motion, const Eigen::Vector3d& down,
                         const Eigen::Vector3d& direction) {
  const Eigen::Quaterniond q(motion.rotation());
  const double angle_rad = 2.0 * std::atan2(q.vec().dot(down), q.w());
  return Levelled(Eigen::AngleAxisd(angle_rad, down) * direction, down);
}

Eigen::Matrix3d BoxAxes(const Eigen::Vector3d& forward, const Eigen::Vector3d& down) {
  Eigen::Matrix3d axes;
  axes << forward, down, forward.cross(down);
  return axes;
}

std::optional<Eigen::Vector3d> DirectionOfMotion(const Cluster& cluster,
                                                 const Eigen::Vector3d& p_in_object,
                                                 const Eigen::Vector3d& down, double least_m) {
  const Eigen::Vector3d now = cluster.Latest().world_from_object * p_in_object;
  for (auto state = cluster.states.rbegin(); state != cluster.states.rend(); ++state) {
    const Eigen::Vector3d moved = now - state->world_from_object * p_in_object;
    const Eigen::Vector3d level = moved - down * down.dot(moved);
    if (level.norm() > least_m) return level.normalized();
  }
  return std::nullopt;
}

}  // namespace cvo
