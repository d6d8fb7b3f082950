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

std::optional<Eigen::Vector3d> StereoCamera::Project(const Eigen::Vector3d& p_in_camera) const {
  if (!(p_in_camera.z() > kMinDepth_m)) return std::nullopt;
  const double inverse_z = 1.0 / p_in_camera.z();
  return Eigen::Vector3d(fx * p_in_camera.x() * inverse_z + cx,
                         fy * p_in_camera.y() * inverse_z + cy,
                         fx * (p_in_camera.x() - baseline_m) * inverse_z + cx + right_shift_px);
}

Eigen::Matrix3d StereoCamera::ProjectionJacobian(const Eigen::Vector3d& p_in_camera) const {
  const double inverse_z = 1.0 / p_in_camera.z();
  const double fx_z = fx * inverse_z;
  const double fy_z = fy * inverse_z;
  Eigen::Matrix3d J;
  J << fx_z, 0.0, -fx_z * p_in_camera.x() * inverse_z,  //
      0.0, fy_z, -fy_z * p_in_camera.y() * inverse_z,   //
      fx_z, 0.0, -fx_z * (p_in_camera.x() - baseline_m) * inverse_z;
  return J;
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
  const double d = depth / disparity;  // -d depth / d disparity
  Eigen::Matrix3d J;
  J << depth / fx - x * d, 0.0, x * d,  //
      -y * d, depth / fy, y * d,        //
      -d, 0.0, d;
  return J;
}

Eigen::Matrix3d StereoCamera::PointCovariance(
    const Eigen::Vector3d& z_px, const Eigen::Matrix3d& measurement_covariance_px2) const {
  const Eigen::Matrix3d J = BackProjectionJacobian(z_px);
  return J * measurement_covariance_px2 * J.transpose();
}

}  // namespace cvo
