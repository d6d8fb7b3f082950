// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/clusters/point_measurements.h"

#include <cmath>

namespace cvo {

std::vector<PointMeasurement> MeasurementsOf(const Options& options,
                                             const std::vector<Landmark>& landmarks,
                                             std::span<const StereoFeature> features,
                                             const std::vector<Match>& matches) {
  std::vector<PointMeasurement> measurements;
  measurements.reserve(matches.size());
  for (const Match& match : matches) {
    const StereoFeature& feature = features[match.feature];
    const double scale = std::pow(options.orb.scale_factor, feature.octave);
    measurements.push_back(
        {landmarks[match.landmark].p_in_body, feature.z_px, SqrtInformation(options.noise, scale)});
  }
  return measurements;
}

}  // namespace cvo
