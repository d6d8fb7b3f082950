// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <opencv2/core/types.hpp>
#include <vector>

#include "core/features/options.h"
#include "core/features/orb/orb.h"
#include "core/geometry/stereo_camera.h"

namespace cvo {

// Row offset v_right - v_left of one scene point, seen at (u, v) in the left image. It is zero
// after a perfect rectification. Real rectifications leave up to 1.6 px that vary smoothly over the
// image (measured on KITTI), and a patch searched for in the wrong row gives a wrong disparity.
struct RowOffset {
  double u_px = 0.0;  // left image
  double v_px = 0.0;
  double disparity_px = 0.0;
  double offset_px = 0.0;
  double sigma_px = 1.0;  // of the offset
};

// Standard deviation of the row difference of two matched corners of a pyramid level, px.
double RowSigma(double scale);

// Row offset over the image: a polynomial in the basis of StereoCamera::BasisAt, and a part
// proportional to the disparity, which is what a baseline that is not level gives.
class RowField {
 public:
  using Vector = Eigen::Matrix<double, 7, 1>;  // FieldBasis, then per px of disparity
  using Matrix = Eigen::Matrix<double, 7, 7>;

  // Zero everywhere, with a wide prior.
  RowField();

  // Robust fit to all samples so far.
  void Add(const std::vector<RowOffset>& samples, const StereoCamera& camera);

  double At(const StereoCamera& camera, double u_px, double v_px, double disparity_px) const;
  const Vector& coefficients() const { return coefficients_; }
  Matrix Covariance() const { return information_.inverse(); }  // of the coefficients

 private:
  Vector coefficients_ = Vector::Zero();
  Matrix information_;
  Vector weighted_ = Vector::Zero();  // information_ * coefficients_
  bool is_empty_ = true;
};

// Matches left corners to the right image: a search along rows for the mutually best and unique
// descriptor, then sub-pixel patch alignment (METHOD.md 2.2). Unmatched corners in `boxes` are kept
// as left-only features. Preserves the order of the left corners.
std::vector<StereoFeature> MatchStereo(const OrbImage& left, const OrbImage& right,
                                       const StereoCamera& camera, const OrbOptions& orb,
                                       const StereoMatchOptions& options,
                                       const std::vector<cv::Rect2d>& boxes = {});

}  // namespace cvo
