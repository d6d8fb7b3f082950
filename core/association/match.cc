// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/association/match.h"

#include <algorithm>
#include <cstddef>

namespace cvo {

std::vector<Match> KeepOneToOne(std::vector<Match> candidates, int landmarks, int features) {
  std::sort(candidates.begin(), candidates.end(), [](const Match& a, const Match& b) {
    if (a.hamming != b.hamming) return a.hamming < b.hamming;
    if (a.landmark != b.landmark) return a.landmark < b.landmark;
    return a.feature < b.feature;
  });
  std::vector<bool> landmark_taken(static_cast<std::size_t>(landmarks), false);
  std::vector<bool> feature_taken(static_cast<std::size_t>(features), false);
  std::vector<Match> kept;
  kept.reserve(candidates.size());
  for (const Match& match : candidates) {
    if (landmark_taken[match.landmark] || feature_taken[match.feature]) continue;
    landmark_taken[match.landmark] = true;
    feature_taken[match.feature] = true;
    kept.push_back(match);
  }
  std::sort(kept.begin(), kept.end(),
            [](const Match& a, const Match& b) { return a.landmark < b.landmark; });
  return kept;
}

}  // namespace cvo
