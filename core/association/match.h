// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

namespace cvo {

// An observation of landmark `landmark` of a list as feature `feature` of a frame.
struct Match {
  int landmark = 0;
  int feature = 0;
  int hamming = 0;  // bits
};

// Keeps the best pairs, such that each landmark and each feature occurs at most once. Ties go to
// the lower landmark, then to the lower feature. The result is sorted by landmark.
std::vector<Match> KeepOneToOne(std::vector<Match> candidates, int landmarks, int features);

}  // namespace cvo
