// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

namespace cvo {

// Landmark `landmark` of a list was observed as feature `feature` of a frame.
struct Match {
  int landmark = 0;
  int feature = 0;
  int hamming = 0;  // bits
};

// The best pairs first, each landmark and each feature at most once; ties go to the lower landmark,
// then to the lower feature. The result is sorted by landmark.
std::vector<Match> KeepOneToOne(std::vector<Match> candidates, int landmarks, int features);

}  // namespace cvo
