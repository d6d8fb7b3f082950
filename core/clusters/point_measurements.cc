// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/clusters/point_measurements.h"

namespace cvo {

std::vector<PointMeasurement> MeasurementsOf(const FeatureNoise& noise,
                                             const std::vector<Landmark>& landmarks,
                                             std::span<const StereoFeature> features,
                                             const std::vector<Match>& matches) {
  std::vector<PointMeasurement> measurements;
  measurements.reserve(matches.size());
  for (const Match& match : matches) {
    const StereoFeature& feature = features[match.feature];
    measurements.push_back(
        {landmarks[match.landmark].p_in_object, feature.z_px, noise.SqrtInformation(feature)});
  }
  return measurements;
}

}  // namespace cvo
