// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/estimation/motion_prior_cost.h"

#include <cmath>

namespace cvo {
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

MotionPriorFactors WhitenMotionPrior(double power_density_m2_s3, double dt_s) {
  const double root = 1.0 / std::sqrt(power_density_m2_s3 * dt_s);
  return {2.0 * std::sqrt(3.0) * root / dt_s, std::sqrt(3.0) * root, root};
}

bool MotionPriorCost::Evaluate(double const* const* blocks, double* residuals,
                               double** jacobians) const {
  const Eigen::Map<const Eigen::Vector3d> t(blocks[0] + 4);
  const Eigen::Map<const Eigen::Vector3d> v(blocks[1]);
  const Eigen::Map<const Eigen::Vector3d> next_t(blocks[2] + 4);
  const Eigen::Map<const Eigen::Vector3d> next_v(blocks[3]);
  Eigen::Map<Vector6d> r(residuals);
  r.head<3>() = factors_.displacement * (next_t - t) - factors_.velocity * (next_v + v);
  r.tail<3>() = factors_.change * (next_v - v);
  if (!jacobians) return true;
  WriteByPose(-factors_.displacement, jacobians[0]);
  WriteByVelocity(-factors_.velocity, -factors_.change, jacobians[1]);
  WriteByPose(factors_.displacement, jacobians[2]);
  WriteByVelocity(-factors_.velocity, factors_.change, jacobians[3]);
  return true;
}

}  // namespace cvo
