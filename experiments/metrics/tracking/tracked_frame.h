// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

namespace cvo {

// Boxes of one frame: identities of true and reported ones, each once, and how similar they are in
// [0, 1] (rows: true). Identities count from 0 without gaps over the sequence.
struct TrackedFrame {
  std::vector<int> truth;
  std::vector<int> estimate;
  Eigen::MatrixXd similarity;
};

struct TrackedSequence {
  int truth_count = 0;  // identities
  int estimate_count = 0;
  std::vector<TrackedFrame> frames;
};

// Limits are compared with this much slack, as TrackEval does: the spacing of doubles at 1.
inline constexpr double kSimilaritySlack = 2.220446049250313e-16;

}  // namespace cvo
