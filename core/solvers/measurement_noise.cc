// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/solvers/measurement_noise.h"

#include "core/features/stereo_feature.h"

namespace cvo {

namespace {

// Whitening matrix for these standard deviations.
Eigen::Matrix3d Whitening(double corner_px, double disparity_px) {
  const double corner = 1.0 / corner_px;
  const double disparity = 1.0 / disparity_px;
  Eigen::Matrix3d W;
  W << corner, 0.0, 0.0,  //
      0.0, corner, 0.0,   //
      disparity, 0.0, -disparity;
  return W;
}

}  // namespace

Eigen::Matrix3d SqrtInformation(const NoiseOptions& noise, double scale) {
  return Whitening(noise.corner_px * scale, noise.disparity_px * scale);
}

Eigen::Matrix3d MeasurementCovariance(const NoiseOptions& noise, double scale) {
  const double corner = noise.corner_px * noise.corner_px * scale * scale;
  const double disparity = noise.disparity_px * noise.disparity_px * scale * scale;
  Eigen::Matrix3d covariance;
  covariance << corner, 0.0, corner,  //
      0.0, corner, 0.0,               //
      corner, 0.0, corner + disparity;
  return covariance;
}

Eigen::Matrix3d FeatureNoise::SqrtInformation(int octave, bool is_aligned,
                                              double disagreement_px) const {
  const double scale = std::pow(scale_factor, octave);
  double disparity_px = options.disparity_px;
  if (HasNoDisparity(disagreement_px)) {
    disparity_px = disagreement_px;
  } else if (options.disagreement > 0.0) {
    disparity_px = std::hypot(options.least_disparity_px, options.disagreement * disagreement_px);
  }
  return Whitening((is_aligned ? options.aligned_px : options.corner_px) * scale,
                   disparity_px * scale);
}

Eigen::Matrix3d FeatureNoise::Covariance(int octave) const {
  return MeasurementCovariance(options, std::pow(scale_factor, octave));
}

}  // namespace cvo
