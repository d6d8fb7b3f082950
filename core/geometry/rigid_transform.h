// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace cvo {

using Vector6d = Eigen::Matrix<double, 6, 1>;
using Matrix6d = Eigen::Matrix<double, 6, 6>;

// Rigid transform a_from_b: p_in_a = a_from_b * p_in_b. Stored as the parameter block [qx qy qz qw
// tx ty tz] of the solvers. The tangent is [rotation, translation] (METHOD.md 1.1): R <- R
// Exp(rotation), t <- t + translation, with the translation in frame a.
class RigidTransform {
 public:
  RigidTransform() { block_ << 0, 0, 0, 1, 0, 0, 0; }
  RigidTransform(const Eigen::Quaterniond& rotation, const Eigen::Vector3d& translation);
  RigidTransform(const Eigen::Matrix3d& rotation, const Eigen::Vector3d& translation);

  Eigen::Map<const Eigen::Quaterniond> rotation() const {
    return Eigen::Map<const Eigen::Quaterniond>(block_.data());
  }
  Eigen::Matrix3d RotationMatrix() const { return rotation().toRotationMatrix(); }
  Eigen::Map<const Eigen::Vector3d> translation() const {
    return Eigen::Map<const Eigen::Vector3d>(block_.data() + 4);
  }
  Eigen::Matrix4d Matrix() const;

  RigidTransform Inverse() const;
  Eigen::Vector3d operator*(const Eigen::Vector3d& p_in_b) const {
    return rotation() * p_in_b + translation();
  }
  RigidTransform operator*(const RigidTransform& b_from_c) const;

  // x.Plus(tangent) is x [+] tangent; y.Minus(x) is the tangent y [-] x, x [+] (y [-] x) = y.
  RigidTransform Plus(const Vector6d& tangent) const;
  Vector6d Minus(const RigidTransform& x) const;

  double* data() { return block_.data(); }
  const double* data() const { return block_.data(); }

 private:
  Eigen::Matrix<double, 7, 1> block_;
};

// Conversion between a rotation vector (axis times angle in [0, pi], rad) and a unit quaternion
// with w >= 0.
Eigen::Quaterniond ExpSo3(const Eigen::Vector3d& rotation_vector);
Eigen::Vector3d LogSo3(const Eigen::Quaterniond& rotation);

// Angle of a rotation in [0, pi], rad.
double RotationAngle(const Eigen::Quaterniond& rotation);

// The matrix with Skew(a) * b = a x b.
Eigen::Matrix3d Skew(const Eigen::Vector3d& a);

// Right Jacobian of SO(3), Exp(v + dv) ~ Exp(v) Exp(J dv), and its inverse.
Eigen::Matrix3d RightJacobianSo3(const Eigen::Vector3d& rotation_vector);
Eigen::Matrix3d InverseRightJacobianSo3(const Eigen::Vector3d& rotation_vector);

// The rotation nearest to M in the Frobenius norm.
Eigen::Matrix3d NearestRotation(const Eigen::Matrix3d& M);

// Returns R, t that minimise sum ||to_i - (R from_i + t)||^2 (Umeyama 1991, without scale). Each
// column is a point; there must be at least one. If the points do not determine R, returns one of
// the minimisers.
RigidTransform AlignPoints(const Eigen::Matrix3Xd& from, const Eigen::Matrix3Xd& to);

}  // namespace cvo
