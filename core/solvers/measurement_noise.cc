// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/solvers/measurement_noise.h"

#include "core/features/stereo_feature.h"

namespace cvo {

Eigen::Matrix3d SqrtInformation(const NoiseOptions& noise, double scale) {
  const double corner = 1.0 / (noise.corner_px * scale);
  const double disparity = 1.0 / (noise.disparity_px * scale);
  Eigen::Matrix3d W;
  W << corner, 0.0, 0.0,  //
      0.0, corner, 0.0,   //
      disparity, 0.0, -disparity;
  return W;
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
  NoiseOptions noise = options;
  if (is_aligned) noise.corner_px = options.aligned_px;
  if (HasNoDisparity(disagreement_px)) {
    noise.disparity_px = disagreement_px;
  } else if (noise.disagreement > 0.0) {
    noise.disparity_px = std::hypot(noise.least_disparity_px, noise.disagreement * disagreement_px);
  }
  return cvo::SqrtInformation(noise, std::pow(scale_factor, octave));
}

Eigen::Matrix3d FeatureNoise::Covariance(int octave) const {
  return MeasurementCovariance(options, std::pow(scale_factor, octave));
}

}  // namespace cvo
