// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/solvers/reprojection_cost.h"

namespace cvo {

ReprojectionResidual EvaluateReprojection(const StereoCamera& camera, const Eigen::Vector3d& z_px,
                                          const Eigen::Matrix3d& sqrt_information,
                                          const RigidTransform& world_from_camera,
                                          const Eigen::Vector3d& p_in_world) {
  const Eigen::Matrix3d R = world_from_camera.RotationMatrix().transpose();
  const Eigen::Vector3d c = R * (p_in_world - world_from_camera.translation());
  const ProjectionResidual projection = EvaluateProjection(camera, z_px, sqrt_information, c);
  ReprojectionResidual result;
  result.r = projection.r;
  result.J_point = projection.J * R;
  result.J_pose.leftCols<3>() = projection.J * Skew(c);
  result.J_pose.rightCols<3>() = -result.J_point;
  result.J_field = sqrt_information.col(2) *
                   camera.BasisAt(projection.zeta_px[0], projection.zeta_px[1]).value.transpose();
  return result;
}

}  // namespace cvo
