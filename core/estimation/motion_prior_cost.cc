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

Vector6d EvaluateMotionPrior(const MotionPriorFactors& factors, const Eigen::Vector3d& t,
                             const Eigen::Vector3d& v, const Eigen::Vector3d& next_t,
                             const Eigen::Vector3d& next_v) {
  Vector6d r;
  r << factors.displacement * (next_t - t) - factors.velocity * (next_v + v),
      factors.change * (next_v - v);
  return r;
}

Eigen::Matrix<double, 2, 4> MotionPriorAxisJacobian(const MotionPriorFactors& factors) {
  Eigen::Matrix<double, 2, 4> J;
  J << -factors.displacement, -factors.velocity, factors.displacement, -factors.velocity,  //
      0.0, -factors.change, 0.0, factors.change;
  return J;
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

}  // namespace cvo
