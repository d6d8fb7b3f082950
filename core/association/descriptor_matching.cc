// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/association/descriptor_matching.h"

#include <algorithm>

#include "core/features/descriptor.h"

namespace cvo {

std::vector<Match> MatchDescriptors(std::span<const Descriptor> landmarks,
                                    std::span<const StereoFeature> features, int max_hamming,
                                    double ratio) {
  constexpr int kFarthest = 257;
  std::vector<int> best_of_feature(features.size(), kFarthest);
  std::vector<Match> candidates;
  for (int i = 0; i < static_cast<int>(landmarks.size()); ++i) {
    int best = kFarthest;
    int second = kFarthest;
    int best_feature = -1;
    for (int k = 0; k < static_cast<int>(features.size()); ++k) {
      if (IsLeftOnly(features[k])) continue;
      const int hamming = HammingDistance(landmarks[i], features[k].descriptor);
      best_of_feature[k] = std::min(best_of_feature[k], hamming);
      if (hamming < best) {
        second = best;
        best = hamming;
        best_feature = k;
      } else if (hamming < second) {
        second = hamming;
      }
    }
    if (best <= max_hamming && best < ratio * second) candidates.push_back({i, best_feature, best});
  }
  std::erase_if(candidates,
                [&](const Match& match) { return match.hamming > best_of_feature[match.feature]; });
  return KeepOneToOne(std::move(candidates), static_cast<int>(landmarks.size()),
                      static_cast<int>(features.size()));
}

}  // namespace cvo
