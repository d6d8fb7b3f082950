// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/stereo_camera.h"

#include <cmath>

#include "core/base/error.h"

namespace cvo {
namespace {

void CheckPositive(const char* field, double value) {
  if (!(std::isfinite(value) && value > 0.0)) {
    ThrowError(StrCat("stereo camera, ", field), StrCat(value), "a positive number");
  }
}

}  // namespace

void StereoCamera::Check() const {
  CheckPositive("fx", fx);
  CheckPositive("fy", fy);
  CheckPositive("baseline", baseline_m);
  CheckPositive("width", width_px);
  CheckPositive("height", height_px);
  if (!std::isfinite(cx) || !std::isfinite(cy)) {
    ThrowError("stereo camera, principal point", StrCat(cx, " ", cy), "finite numbers");
  }
}

std::optional<Eigen::Vector3d> StereoCamera::BackProject(const Eigen::Vector3d& z_px) const {
  const double disparity = Disparity(z_px);
  if (!(disparity > 0.0)) return std::nullopt;
  const double depth = fx * baseline_m / disparity;
  return Eigen::Vector3d((z_px[0] - cx) * depth / fx, (z_px[1] - cy) * depth / fy, depth);
}

Eigen::Matrix3d StereoCamera::BackProjectionJacobian(const Eigen::Vector3d& z_px) const {
  const double disparity = Disparity(z_px);
  const double depth = fx * baseline_m / disparity;
  const double x = (z_px[0] - cx) / fx;
  const double y = (z_px[1] - cy) / fy;
  const FieldBasis basis = BasisAt(z_px[0], z_px[1]);
  const Eigen::RowVector3d disparity_by_z(1.0 + right_field_px.dot(basis.by_u),
                                          right_field_px.dot(basis.by_v), -1.0);
  Eigen::Matrix3d J = -depth / disparity * Eigen::Vector3d(x, y, 1.0) * disparity_by_z;
  J(0, 0) += depth / fx;
  J(1, 1) += depth / fy;
  return J;
}

Eigen::Matrix3d StereoCamera::PointCovariance(
    const Eigen::Vector3d& z_px, const Eigen::Matrix3d& measurement_covariance_px2) const {
  const Eigen::Matrix3d J = BackProjectionJacobian(z_px);
  return J * measurement_covariance_px2 * J.transpose();
}

}  // namespace cvo
