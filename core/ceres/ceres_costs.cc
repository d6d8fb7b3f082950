// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/ceres/ceres_costs.h"

#include <algorithm>

namespace cvo::ceres_costs {
namespace {

using PoseJacobian = Eigen::Matrix<double, 6, 7, Eigen::RowMajor>;
using VelocityJacobian = Eigen::Matrix<double, 6, 3, Eigen::RowMajor>;

void WriteByPose(double displacement, double* jacobian) {
  if (!jacobian) return;
  Eigen::Map<PoseJacobian> J(jacobian);
  J.setZero();
  J.block<3, 3>(0, 3).diagonal().setConstant(displacement);
}

void WriteByVelocity(double velocity, double change, double* jacobian) {
  if (!jacobian) return;
  Eigen::Map<VelocityJacobian> J(jacobian);
  J << velocity * Eigen::Matrix3d::Identity(), change * Eigen::Matrix3d::Identity();
}

}  // namespace

RigidTransform PoseFromBlock(const double* block) {
  return {Eigen::Quaterniond(Eigen::Map<const Eigen::Quaterniond>(block)),
          Eigen::Vector3d(Eigen::Map<const Eigen::Vector3d>(block + 4))};
}

bool PoseManifold::Plus(const double* x, const double* delta, double* x_plus_delta) const {
  const RigidTransform moved = PoseFromBlock(x).Plus(Eigen::Map<const Vector6d>(delta));
  std::copy_n(moved.data(), 7, x_plus_delta);
  return true;
}

bool PoseManifold::PlusJacobian(const double*, double* jacobian) const {
  Eigen::Map<Eigen::Matrix<double, 7, 6, Eigen::RowMajor>> J(jacobian);
  J.setZero();
  J.topRows<6>().setIdentity();
  return true;
}

bool PoseManifold::Minus(const double* y, const double* x, double* y_minus_x) const {
  Eigen::Map<Vector6d> tangent(y_minus_x);
  tangent = PoseFromBlock(y).Minus(PoseFromBlock(x));
  return true;
}

bool PoseManifold::MinusJacobian(const double*, double* jacobian) const {
  Eigen::Map<Eigen::Matrix<double, 6, 7, Eigen::RowMajor>> J(jacobian);
  J.setZero();
  J.leftCols<6>().setIdentity();
  return true;
}

bool ReprojectionCost::Evaluate(double const* const* blocks, double* residuals,
                                double** jacobians) const {
  const Eigen::Map<const Eigen::Quaterniond> q(blocks[0]);
  const Eigen::Map<const Eigen::Vector3d> position(blocks[0] + 4);
  const Eigen::Map<const Eigen::Vector3d> p_in_world(blocks[1]);
  StereoCamera camera = camera_;
  camera.right_field_px = Eigen::Map<const Vector6d>(blocks[2]);
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
    Eigen::Map<Eigen::Matrix<double, 3, 6, Eigen::RowMajor>> J(jacobians[2]);
    J = value.J_field;
  }
  return true;
}

PriorCost::PriorCost(const WindowPrior& prior) : prior_(&prior) {
  set_num_residuals(static_cast<int>(prior.r0.size()));
  mutable_parameter_block_sizes()->assign(prior.frames.size(), 7);
  mutable_parameter_block_sizes()->push_back(6);
}

bool PriorCost::Evaluate(double const* const* blocks, double* residuals, double** jacobians) const {
  const int frames = static_cast<int>(prior_->frames.size());
  Eigen::VectorXd dx(6 * frames + 6);
  for (int i = 0; i < frames; ++i) {
    dx.segment<6>(6 * i) = PoseFromBlock(blocks[i]).Minus(prior_->linearization_point[i]);
  }
  dx.tail<6>() = Eigen::Map<const Vector6d>(blocks[frames]) - prior_->right_field_point_px;
  const Eigen::Index rows = prior_->r0.size();
  Eigen::Map<Eigen::VectorXd> r(residuals, rows);
  r = prior_->r0 + prior_->J0 * dx;
  if (!jacobians) return true;
  for (int i = 0; i < frames; ++i) {
    if (!jacobians[i]) continue;
    Eigen::Map<Eigen::Matrix<double, Eigen::Dynamic, 7, Eigen::RowMajor>> J(jacobians[i], rows, 7);
    const auto J0 = prior_->J0.middleCols<6>(6 * i);
    J.leftCols<3>() = J0.leftCols<3>() * InverseRightJacobianSo3(dx.segment<3>(6 * i));
    J.middleCols<3>(3) = J0.rightCols<3>();
    J.col(6).setZero();
  }
  if (jacobians[frames]) {
    Eigen::Map<Eigen::Matrix<double, Eigen::Dynamic, 6, Eigen::RowMajor>> J(jacobians[frames], rows,
                                                                            6);
    J = prior_->J0.rightCols<6>();
  }
  return true;
}

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

bool MotionPriorCost::Evaluate(double const* const* blocks, double* residuals,
                               double** jacobians) const {
  using Vector = Eigen::Map<const Eigen::Vector3d>;
  Eigen::Map<Vector6d> r(residuals);
  r = EvaluateMotionPrior(factors_, Vector(blocks[0] + 4), Vector(blocks[1]), Vector(blocks[2] + 4),
                          Vector(blocks[3]));
  if (!jacobians) return true;
  const Eigen::Matrix<double, 2, 4> J = MotionPriorAxisJacobian(factors_);
  WriteByPose(J(0, 0), jacobians[0]);
  WriteByVelocity(J(0, 1), J(1, 1), jacobians[1]);
  WriteByPose(J(0, 2), jacobians[2]);
  WriteByVelocity(J(0, 3), J(1, 3), jacobians[3]);
  return true;
}

bool TurnPriorCost::Evaluate(double const* const* blocks, double* residuals,
                             double** jacobians) const {
  std::array<Eigen::Quaterniond, 3> world_from_object;
  for (int i = 0; i < 3; ++i) {
    world_from_object[i] = Eigen::Map<const Eigen::Quaterniond>(blocks[i]);
  }
  const TurnPrior value = EvaluateTurnPrior(power_density_rad2_s3_, dt_s_, world_from_object);
  Eigen::Map<Eigen::Vector3d> r(residuals);
  r = value.r;
  if (!jacobians) return true;
  for (int i = 0; i < 3; ++i) {
    if (!jacobians[i]) continue;
    Eigen::Map<Eigen::Matrix<double, 3, 7, Eigen::RowMajor>> J(jacobians[i]);
    J.setZero();
    // value.J is with respect to rotations about world axes, the manifold's tangent about body
    // axes.
    J.leftCols<3>() = value.J[i] * world_from_object[i].toRotationMatrix();
  }
  return true;
}

}  // namespace cvo::ceres_costs
