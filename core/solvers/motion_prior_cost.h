// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "core/geometry/rigid_transform.h"

namespace cvo {

// White-noise-on-acceleration prior between two states dt_s apart (section 3.3 of the paper;
// METHOD.md 8.2): e = (t+ - t - dt v, v+ - v), ||r||^2 = e^T Qhat^-1 e with
//   r = (displacement (t+ - t) - velocity (v+ + v), change (v+ - v)),
// so that these factors make up the Jacobians with respect to t, v, t+ and v+.
struct MotionPriorFactors {
  double displacement = 0.0;  // 1/m
  double velocity = 0.0;      // s/m
  double change = 0.0;        // s/m
};
MotionPriorFactors WhitenMotionPrior(double power_density_m2_s3, double dt_s);

Vector6d EvaluateMotionPrior(const MotionPriorFactors& factors, const Eigen::Vector3d& t,
                             const Eigen::Vector3d& v, const Eigen::Vector3d& next_t,
                             const Eigen::Vector3d& next_v);
// Jacobian for one axis: of (r_k, r_{3+k}) with respect to (t_k, v_k, t+_k, v+_k).
Eigen::Matrix<double, 2, 4> MotionPriorAxisJacobian(const MotionPriorFactors& factors);

// White noise on the angular acceleration, for three consecutive orientations world_from_object:
//   r = (w_b - w_a) / sqrt(q (dt_a + dt_b) / 3),  w = Log(R+ R^-1) / dt in world.
// The variance is that of the change of the mean rate from one step to the next. Jacobians are with
// respect to rotations about world axes, applied from the left.
struct TurnPrior {
  Eigen::Vector3d r;
  std::array<Eigen::Matrix3d, 3> J;
};
TurnPrior EvaluateTurnPrior(double power_density_rad2_s3, const std::array<double, 2>& dt_s,
                            const std::array<Eigen::Quaterniond, 3>& world_from_object);

}  // namespace cvo
