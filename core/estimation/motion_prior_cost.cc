// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/estimation/motion_prior_cost.h"

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

}  // namespace cvo
