// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <optional>

#include "core/geometry/rigid_transform.h"

namespace cvo {

// Basis of the quadratic polynomials over the left image: 1, x, y, x^2 - 1/3, xy, y^2 - 1/3, with x
// and y relative to the image centre in units of half the image sides. The first coefficient of a
// polynomial is its mean over the image.
struct FieldBasis {
  Vector6d value;
  Vector6d by_u;  // d value / du, per px
  Vector6d by_v;  // d value / dv, per px
};

// Rectified stereo pair (METHOD.md 1.2). The camera frame is the left camera's: x right, y
// down, z forward, metres. A measurement is z = (u_left, v, u_right) in pixels, pixel centres at
// integers.
struct StereoCamera {
  double fx = 0.0;          // px
  double fy = 0.0;          // px
  double cx = 0.0;          // px
  double cy = 0.0;          // px
  double baseline_m = 0.0;  // > 0
  int width_px = 0;
  int height_px = 0;
  // Rectification error: u_right lies this much further right than in a perfect pair. A hundredth
  // of a degree of vergence is 0.13 px at the focal length of KITTI.
  double right_shift_px = 0.0;
  // Estimated correction that is added to right_shift_px, as coefficients of FieldBasis: real
  // rectifications leave an error that varies over the image.
  Vector6d right_field_px = Vector6d::Zero();

  // Throws Error naming an invalid field.
  void Check() const;

  FieldBasis BasisAt(double u_px, double v_px) const;
  // Returns how much further right u_right lies than in a perfect pair, px.
  double RightShift(double u_px, double v_px) const {
    return right_shift_px + right_field_px.dot(BasisAt(u_px, v_px).value);
  }

  // u_left - u_right as a perfect pair would measure it, px: fx * baseline / depth.
  double Disparity(const Eigen::Vector3d& z_px) const {
    return z_px[0] - z_px[2] + RightShift(z_px[0], z_px[1]);
  }

  // pi(p). Empty if the point is nearer than kMinDepth_m or behind the camera.
  [[nodiscard]] std::optional<Eigen::Vector3d> Project(const Eigen::Vector3d& p_in_camera) const;
  // d pi / d p, 3x3, for a point with positive depth.
  Eigen::Matrix3d ProjectionJacobian(const Eigen::Vector3d& p_in_camera) const;
  // pi^-1(z). Empty if the disparity is not positive.
  [[nodiscard]] std::optional<Eigen::Vector3d> BackProject(const Eigen::Vector3d& z_px) const;
  // d pi^-1 / d z for a positive disparity.
  Eigen::Matrix3d BackProjectionJacobian(const Eigen::Vector3d& z_px) const;
  // Covariance of pi^-1(z), m^2, for a measurement covariance in px^2 (section 3 of the paper).
  Eigen::Matrix3d PointCovariance(const Eigen::Vector3d& z_px,
                                  const Eigen::Matrix3d& measurement_covariance_px2) const;

  // Whether a left pixel is within the image.
  bool InImage(double u_px, double v_px) const {
    return u_px >= 0.0 && v_px >= 0.0 && u_px <= width_px - 1 && v_px <= height_px - 1;
  }

  static constexpr double kMinDepth_m = 0.05;
};

// Inline, because the inner loops of the solvers call them.
inline FieldBasis StereoCamera::BasisAt(double u_px, double v_px) const {
  const double by_u = 2.0 / std::max(width_px, 1);
  const double by_v = 2.0 / std::max(height_px, 1);
  const double x = by_u * (u_px + 0.5) - 1.0;
  const double y = by_v * (v_px + 0.5) - 1.0;
  FieldBasis basis;
  basis.value << 1.0, x, y, x * x - 1.0 / 3.0, x * y, y * y - 1.0 / 3.0;
  basis.by_u << 0.0, by_u, 0.0, 2.0 * by_u * x, by_u * y, 0.0;
  basis.by_v << 0.0, 0.0, by_v, 0.0, by_v * x, 2.0 * by_v * y;
  return basis;
}

inline std::optional<Eigen::Vector3d> StereoCamera::Project(
    const Eigen::Vector3d& p_in_camera) const {
  if (!(p_in_camera.z() > kMinDepth_m)) return std::nullopt;
  const double inverse_z = 1.0 / p_in_camera.z();
  const double u = fx * p_in_camera.x() * inverse_z + cx;
  const double v = fy * p_in_camera.y() * inverse_z + cy;
  return Eigen::Vector3d(u, v, u - fx * baseline_m * inverse_z + RightShift(u, v));
}

inline Eigen::Matrix3d StereoCamera::ProjectionJacobian(const Eigen::Vector3d& p_in_camera) const {
  const double inverse_z = 1.0 / p_in_camera.z();
  const double fx_z = fx * inverse_z;
  const double fy_z = fy * inverse_z;
  Eigen::Matrix3d J;
  J << fx_z, 0.0, -fx_z * p_in_camera.x() * inverse_z,  //
      0.0, fy_z, -fy_z * p_in_camera.y() * inverse_z,   //
      fx_z, 0.0, -fx_z * (p_in_camera.x() - baseline_m) * inverse_z;
  const FieldBasis basis = BasisAt(fx_z * p_in_camera.x() + cx, fy_z * p_in_camera.y() + cy);
  J.row(2) += right_field_px.dot(basis.by_u) * J.row(0) + right_field_px.dot(basis.by_v) * J.row(1);
  return J;
}

// An axis-aligned rectangle in the left image, px, with pixel centres at integers. It may extend
// beyond the image.
struct ImageBox {
  double left_px = 0.0;
  double top_px = 0.0;
  double right_px = 0.0;   // >= left_px
  double bottom_px = 0.0;  // >= top_px

  double Width() const { return right_px - left_px; }
  double Height() const { return bottom_px - top_px; }
  bool Contains(double u_px, double v_px) const {
    return u_px >= left_px && u_px <= right_px && v_px >= top_px && v_px <= bottom_px;
  }
  // The box with each side moved inwards by `fraction` of its width or height (outwards if < 0).
  ImageBox Shrunk(double fraction) const;
};

// Area of the intersection over area of the union, in [0, 1]; 0 if the boxes do not overlap.
double IntersectionOverUnion(const ImageBox& a, const ImageBox& b);

// Share of the area of `part` that lies inside `whole`, in [0, 1]; 0 if `part` has no area.
double ShareInside(const ImageBox& part, const ImageBox& whole);

// Returns the part of the box within the left image. Empty if the box is outside the image.
[[nodiscard]] std::optional<ImageBox> ClipToImage(const ImageBox& box, const StereoCamera& camera);

}  // namespace cvo
