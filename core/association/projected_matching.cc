// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/association/projected_matching.h"

#include <cmath>
#include <cstdlib>

#include "core/features/descriptor.h"

namespace cvo {
namespace {

// The feature with the nearest descriptor around a projection, and the two smallest distances.
struct Nearest {
  int feature = -1;
  int hamming = 257;
  int second = 257;
};

Nearest FindNearest(const ProjectedLandmark& landmark, const FeatureGrid& grid, double radius_px) {
  Nearest nearest;
  grid.VisitNear(landmark.zeta_px[0], landmark.zeta_px[1], radius_px, [&](int index) {
    const StereoFeature& feature = grid.features()[index];
    if (std::abs(feature.octave - landmark.octave) > 1) return;
    if (std::abs(feature.z_px[2] - landmark.zeta_px[2]) > radius_px) return;
    const int hamming = HammingDistance(feature.descriptor, landmark.descriptor);
    if (hamming < nearest.hamming) {
      nearest.second = nearest.hamming;
      nearest.hamming = hamming;
      nearest.feature = index;
    } else if (hamming < nearest.second) {
      nearest.second = hamming;
    }
  });
  return nearest;
}

}  // namespace

std::vector<Match> MatchProjected(std::span<const ProjectedLandmark> landmarks,
                                  const FeatureGrid& grid, double radius_px, double scale_factor,
                                  const MatchingOptions& options) {
  std::vector<Match> candidates;
  candidates.reserve(landmarks.size());
  for (int i = 0; i < static_cast<int>(landmarks.size()); ++i) {
    const double radius = radius_px * std::pow(scale_factor, landmarks[i].octave);
    const Nearest nearest = FindNearest(landmarks[i], grid, radius);
    if (nearest.hamming > options.max_hamming) continue;
    if (nearest.hamming >= options.ratio * nearest.second) continue;
    candidates.push_back({i, nearest.feature, nearest.hamming});
  }
  return KeepOneToOne(std::move(candidates), static_cast<int>(landmarks.size()),
                      static_cast<int>(grid.features().size()));
}

}  // namespace cvo
