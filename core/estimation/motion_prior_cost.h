// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/rigid_transform.h"

namespace cvo {

// The white-noise-on-acceleration prior between two states dt_s apart (section 3.3 of the paper;
// estimator.md 5): e = (t+ - t - dt v, v+ - v), ||r||^2 = e^T Qhat^-1 e with
//   r = (displacement (t+ - t) - velocity (v+ + v), change (v+ - v)),
// so that the Jacobian by each of t, v, t+, v+ is made of these factors.
struct MotionPriorFactors {
  double displacement = 0.0;  // 1/m
  double velocity = 0.0;      // s/m
  double change = 0.0;        // s/m
};
MotionPriorFactors WhitenMotionPrior(double power_density_m2_s3, double dt_s);

Vector6d EvaluateMotionPrior(const MotionPriorFactors& factors, const Eigen::Vector3d& t,
                             const Eigen::Vector3d& v, const Eigen::Vector3d& next_t,
                             const Eigen::Vector3d& next_v);
// Of one axis: (r_k, r_{3+k}) by (t_k, v_k, t+_k, v+_k).
Eigen::Matrix<double, 2, 4> MotionPriorAxisJacobian(const MotionPriorFactors& factors);

}  // namespace cvo
