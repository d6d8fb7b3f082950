// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

namespace cvo {

// Row offset v_right - v_left of one scene point seen at (u, v) in the left image. It is zero after
// a perfect rectification. Real rectifications leave up to 1.5 px that vary smoothly over the image
// (measured on KITTI), and a patch searched for in the wrong row gives a wrong disparity.
struct RowOffsetSample {
  double u_px = 0.0;  // left image
  double v_px = 0.0;
  double offset_px = 0.0;
  double sigma_px = 1.0;  // of the offset
};

// Row offset over the image, as a quadratic polynomial.
class RowOffset {
 public:
  // Zero everywhere.
  RowOffset() = default;
  // Robust fit, with a prior that draws it to zero where there are few samples.
  RowOffset(const std::vector<RowOffsetSample>& samples, double width_px, double height_px);

  double At(double u_px, double v_px) const { return coefficients_.dot(Basis(u_px, v_px)); }

 private:
  using Vector6 = Eigen::Matrix<double, 6, 1>;

  Vector6 Basis(double u_px, double v_px) const;

  double width_px_ = 1.0;
  double height_px_ = 1.0;
  Vector6 coefficients_ = Vector6::Zero();
};

}  // namespace cvo
