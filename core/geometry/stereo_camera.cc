// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/stereo_camera.h"

#include <algorithm>
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

ImageBox ImageBox::Shrunk(double fraction) const {
  const double dx = fraction * Width();
  const double dy = fraction * Height();
  return {left_px + dx, top_px + dy, right_px - dx, bottom_px - dy};
}

namespace {

double Area(const ImageBox& box) { return box.Width() * box.Height(); }

double CommonArea(const ImageBox& a, const ImageBox& b) {
  const double width = std::min(a.right_px, b.right_px) - std::max(a.left_px, b.left_px);
  const double height = std::min(a.bottom_px, b.bottom_px) - std::max(a.top_px, b.top_px);
  return width <= 0.0 || height <= 0.0 ? 0.0 : width * height;
}

}  // namespace

double IntersectionOverUnion(const ImageBox& a, const ImageBox& b) {
  const double common = CommonArea(a, b);
  return common > 0.0 ? common / (Area(a) + Area(b) - common) : 0.0;
}

double ShareInside(const ImageBox& part, const ImageBox& whole) {
  const double common = CommonArea(part, whole);
  return common > 0.0 ? common / Area(part) : 0.0;
}

std::optional<ImageBox> ClipToImage(const ImageBox& box, const StereoCamera& camera) {
  const double right_px = camera.width_px - 1;
  const double bottom_px = camera.height_px - 1;
  if (box.right_px < 0.0 || box.bottom_px < 0.0 || box.left_px > right_px ||
      box.top_px > bottom_px) {
    return std::nullopt;
  }
  return ImageBox{std::max(box.left_px, 0.0), std::max(box.top_px, 0.0),
                  std::min(box.right_px, right_px), std::min(box.bottom_px, bottom_px)};
}

}  // namespace cvo
