// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/estimation/reprojection_cost.h"

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
  result.J_shift = sqrt_information.col(2);
  return result;
}

bool ReprojectionCost::Evaluate(double const* const* blocks, double* residuals,
                                double** jacobians) const {
  const Eigen::Map<const Eigen::Quaterniond> q(blocks[0]);
  const Eigen::Map<const Eigen::Vector3d> position(blocks[0] + 4);
  const Eigen::Map<const Eigen::Vector3d> p_in_world(blocks[1]);
  StereoCamera camera = camera_;
  camera.right_shift_px = blocks[2][0];
  const ReprojectionResidual value = EvaluateReprojection(
      camera, z_px_, sqrt_information_,
      RigidTransform(Eigen::Quaterniond(q), Eigen::Vector3d(position)), p_in_world);
  Eigen::Map<Eigen::Vector3d> r(residuals);
  r = value.r;
  if (!jacobians) return true;
  if (jacobians[0]) {
    Eigen::Map<Eigen::Matrix<double, 3, 7, Eigen::RowMajor>> J(jacobians[0]);
    J << value.J_pose, Eigen::Vector3d::Zero();
  }
  if (jacobians[1]) {
    Eigen::Map<Eigen::Matrix<double, 3, 3, Eigen::RowMajor>> J(jacobians[1]);
    J = value.J_point;
  }
  if (jacobians[2]) {
    Eigen::Map<Eigen::Vector3d> J(jacobians[2]);
    J = value.J_shift;
  }
  return true;
}

}  // namespace cvo
