// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "core/association/feature_grid.h"
#include "core/association/match.h"
#include "core/base/options.h"

namespace cvo {

// A landmark at its predicted position in the current frame.
struct ProjectedLandmark {
  Eigen::Vector3d zeta_px = Eigen::Vector3d::Zero();  // predicted (u_left, v, u_right)
  int octave = 0;                                     // predicted pyramid level
  Descriptor descriptor{};
};

struct MatchingOptions {
  double wide_radius_px = 20.0;
  double narrow_radius_px = 4.0;
  int max_hamming = 80;
  double ratio = 0.9;

  template <typename Self, typename Visitor>
  static void VisitFields(Self& self, Visitor& visit) {
    visit.Field("wide_radius_px", self.wide_radius_px,
                {"px", 1, 500,
                 "search radius with the predicted camera pose, at level 0; larger tolerates "
                 "sharper turns, smaller gives fewer false matches",
                 "chosen on KITTI at 10 Hz"});
    visit.Field("narrow_radius_px", self.narrow_radius_px,
                {"px", 0.5, 100, "search radius with the solved camera pose, at level 0",
                 "4 standard deviations of a corner"});
    visit.Field("max_hamming", self.max_hamming,
                {"bits", 1, 256, "maximum descriptor distance of a match", "METHOD.md 3.1"});
    visit.Field(
        "ratio", self.ratio,
        {"1", 0.1, 1.0, "maximum ratio of the best to the second best distance", "METHOD.md 3.1"});
  }
};

// Matches each landmark to the feature with the nearest descriptor within radius_px *
// scale_factor^octave of its projection, in all three coordinates, and within one pyramid level.
// Matches are unique and one-to-one.
std::vector<Match> MatchProjected(std::span<const ProjectedLandmark> landmarks,
                                  const FeatureGrid& grid, double radius_px, double scale_factor,
                                  const MatchingOptions& options);

}  // namespace cvo
