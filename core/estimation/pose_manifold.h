// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ceres/manifold.h>

namespace cvo {

// RigidTransform::Plus and Minus for Ceres. The costs of this folder write their Jacobians with
// respect to the tangent into the first six of the block's seven columns, so PlusJacobian is
// [I6; 0] (estimator.md 4.5): on these blocks, tools that differentiate with respect to the ambient
// space see nothing sensible.
class PoseManifold final : public ceres::Manifold {
 public:
  int AmbientSize() const override { return 7; }
  int TangentSize() const override { return 6; }
  bool Plus(const double* x, const double* delta, double* x_plus_delta) const override;
  bool PlusJacobian(const double* x, double* jacobian) const override;
  bool Minus(const double* y, const double* x, double* y_minus_x) const override;
  bool MinusJacobian(const double* x, double* jacobian) const override;
};

// Reads and writes the block [qx qy qz qw tx ty tz].
class RigidTransform;
RigidTransform PoseFromBlock(const double* block);

}  // namespace cvo
