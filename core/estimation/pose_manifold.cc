// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/estimation/pose_manifold.h"

#include <algorithm>

#include "core/geometry/rigid_transform.h"

namespace cvo {

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

}  // namespace cvo
