// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/solvers/motion_prior.h"

#include <cmath>

namespace cvo {

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

TurnPrior EvaluateTurnPrior(double power_density_rad2_s3, const std::array<double, 2>& dt_s,
                            const std::array<Eigen::Quaterniond, 3>& world_from_object) {
  const double factor = std::sqrt(3.0 / (power_density_rad2_s3 * (dt_s[0] + dt_s[1])));
  std::array<Eigen::Vector3d, 2> turn;
  for (int i = 0; i < 2; ++i) {
    turn[i] = LogSo3(world_from_object[i + 1] * world_from_object[i].conjugate());
  }
  const Eigen::Matrix3d by_before = factor / dt_s[0] * InverseRightJacobianSo3(turn[0]);
  const Eigen::Matrix3d by_after = factor / dt_s[1] * InverseRightJacobianSo3(-turn[1]);
  TurnPrior prior;
  prior.r = factor * (turn[1] / dt_s[1] - turn[0] / dt_s[0]);
  prior.J[0] = by_before;
  prior.J[1] = -factor / dt_s[1] * InverseRightJacobianSo3(turn[1]) -
               factor / dt_s[0] * InverseRightJacobianSo3(-turn[0]);
  prior.J[2] = by_after;
  return prior;
}

}  // namespace cvo
