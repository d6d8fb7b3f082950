// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/rigid_transform.h"

#include <Eigen/SVD>
#include <cmath>

#include "core/base/error.h"

namespace cvo {

RigidTransform::RigidTransform(const Eigen::Quaterniond& rotation,
                               const Eigen::Vector3d& translation) {
  block_ << rotation.normalized().coeffs(), translation;
}

RigidTransform::RigidTransform(const Eigen::Matrix3d& rotation, const Eigen::Vector3d& translation)
    : RigidTransform(Eigen::Quaterniond(rotation), translation) {}

Eigen::Matrix4d RigidTransform::Matrix() const {
  Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
  matrix.topLeftCorner<3, 3>() = RotationMatrix();
  matrix.topRightCorner<3, 1>() = translation();
  return matrix;
}

RigidTransform RigidTransform::Inverse() const {
  const Eigen::Quaterniond inverse = rotation().conjugate();
  return {inverse, -(inverse * translation())};
}

RigidTransform RigidTransform::operator*(const RigidTransform& b_from_c) const {
  return {Eigen::Quaterniond(rotation() * b_from_c.rotation()), *this * b_from_c.translation()};
}

RigidTransform RigidTransform::Plus(const Vector6d& tangent) const {
  return {Eigen::Quaterniond(rotation() * ExpSo3(tangent.head<3>())),
          translation() + tangent.tail<3>()};
}

Vector6d RigidTransform::Minus(const RigidTransform& x) const {
  Vector6d tangent;
  tangent << LogSo3(x.rotation().conjugate() * rotation()), translation() - x.translation();
  return tangent;
}

Eigen::Quaterniond ExpSo3(const Eigen::Vector3d& rotation_vector) {
  const double angle = rotation_vector.norm();
  // sin(angle / 2) / angle, from its series near zero.
  const double s = angle < 1e-4 ? 0.5 - angle * angle / 48.0 : std::sin(0.5 * angle) / angle;
  Eigen::Quaterniond q;
  q.w() = std::cos(0.5 * angle);
  q.vec() = s * rotation_vector;
  if (q.w() < 0.0) q.coeffs() = -q.coeffs();
  return q.normalized();
}

Eigen::Vector3d LogSo3(const Eigen::Quaterniond& rotation) {
  const double sign = rotation.w() < 0.0 ? -1.0 : 1.0;
  const Eigen::Vector3d v = sign * rotation.vec();
  const double w = sign * rotation.w();
  const double sine = v.norm();
  // angle / sin(angle / 2), from its series near zero.
  const double scale = sine < 1e-6 ? 2.0 / w * (1.0 - sine * sine / (3.0 * w * w))
                                   : 2.0 * std::atan2(sine, w) / sine;
  return scale * v;
}

double RotationAngle(const Eigen::Quaterniond& rotation) {
  return 2.0 * std::atan2(rotation.vec().norm(), std::abs(rotation.w()));
}

Eigen::Matrix3d Skew(const Eigen::Vector3d& a) {
  Eigen::Matrix3d matrix;
  matrix << 0, -a.z(), a.y(), a.z(), 0, -a.x(), -a.y(), a.x(), 0;
  return matrix;
}

Eigen::Matrix3d RightJacobianSo3(const Eigen::Vector3d& rotation_vector) {
  const double angle = rotation_vector.norm();
  const Eigen::Matrix3d K = Skew(rotation_vector);
  if (angle < 1e-5) return Eigen::Matrix3d::Identity() - 0.5 * K + K * K / 6.0;
  const double square = angle * angle;
  return Eigen::Matrix3d::Identity() - (1.0 - std::cos(angle)) / square * K +
         (angle - std::sin(angle)) / (square * angle) * K * K;
}

Eigen::Matrix3d InverseRightJacobianSo3(const Eigen::Vector3d& rotation_vector) {
  const double angle = rotation_vector.norm();
  const Eigen::Matrix3d K = Skew(rotation_vector);
  if (angle < 1e-5) return Eigen::Matrix3d::Identity() + 0.5 * K + K * K / 12.0;
  const double half = 0.5 * angle;
  return Eigen::Matrix3d::Identity() + 0.5 * K +
         (1.0 - half / std::tan(half)) / (angle * angle) * K * K;
}

Eigen::Matrix3d NearestRotation(const Eigen::Matrix3d& M) {
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(M, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Eigen::Vector3d signs = Eigen::Vector3d::Ones();
  if ((svd.matrixU() * svd.matrixV().transpose()).determinant() < 0.0) signs.z() = -1.0;
  return svd.matrixU() * signs.asDiagonal() * svd.matrixV().transpose();
}

RigidTransform AlignPoints(const Eigen::Matrix3Xd& from, const Eigen::Matrix3Xd& to) {
  Require(from.cols() == to.cols() && from.cols() > 0, "AlignPoints: needs pairs of points");
  const Eigen::Vector3d from_mean = from.rowwise().mean();
  const Eigen::Vector3d to_mean = to.rowwise().mean();
  const Eigen::Matrix3d covariance =
      (to.colwise() - to_mean) * (from.colwise() - from_mean).transpose();
  const Eigen::Matrix3d R = NearestRotation(covariance);
  return {R, to_mean - R * from_mean};
}

}  // namespace cvo
