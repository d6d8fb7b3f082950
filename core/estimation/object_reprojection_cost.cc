// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/estimation/object_reprojection_cost.h"

#include "core/estimation/pose_manifold.h"

namespace cvo {

ObjectReprojectionResidual EvaluateObjectReprojection(const StereoCamera& camera,
                                                      const Eigen::Vector3d& z_px,
                                                      const Eigen::Matrix3d& sqrt_information,
                                                      const RigidTransform& world_from_camera,
                                                      const RigidTransform& world_from_object,
                                                      const Eigen::Vector3d& p_in_object) {
  const Eigen::Matrix3d R = world_from_camera.RotationMatrix().transpose();
  const Eigen::Matrix3d R_object = world_from_object.RotationMatrix();
  const Eigen::Vector3d c = R * (R_object * p_in_object + (world_from_object.translation() -
                                                           world_from_camera.translation()));
  const ProjectionResidual projection = EvaluateProjection(camera, z_px, sqrt_information, c);
  ObjectReprojectionResidual result;
  result.r = projection.r;
  result.J_pose.rightCols<3>() = projection.J * R;
  result.J_point = result.J_pose.rightCols<3>() * R_object;
  result.J_pose.leftCols<3>() = -result.J_point * Skew(p_in_object);
  return result;
}

bool ObjectReprojectionCost::Evaluate(double const* const* blocks, double* residuals,
                                      double** jacobians) const {
  const Eigen::Map<const Eigen::Vector3d> p_in_object(blocks[1]);
  const ObjectReprojectionResidual value = EvaluateObjectReprojection(
      camera_, z_px_, sqrt_information_, world_from_camera_, PoseFromBlock(blocks[0]), p_in_object);
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
  return true;
}

}  // namespace cvo
