// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "core/association/assignment.h"
#include "experiments/metrics/tracking/tracking_scores.h"

namespace cvo {

IdentityScores EvaluateIdentities(const TrackedSequence& sequence) {
  constexpr double kLeast = 0.5;
  Eigen::MatrixXd together = Eigen::MatrixXd::Zero(sequence.truth_count, sequence.estimate_count);
  double truth = 0.0;
  double estimate = 0.0;
  for (const TrackedFrame& frame : sequence.frames) {
    truth += static_cast<double>(frame.truth.size());
    estimate += static_cast<double>(frame.estimate.size());
    for (std::size_t i = 0; i < frame.truth.size(); ++i) {
      for (std::size_t j = 0; j < frame.estimate.size(); ++j) {
        if (frame.similarity(i, j) >= kLeast) together(frame.truth[i], frame.estimate[j]) += 1.0;
      }
    }
  }
  // Each common box of a pair of tracks saves two errors: one missed and one false box.
  const std::vector<int> columns = Assign(-together);
  double matches = 0.0;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (columns[i] >= 0) matches += together(static_cast<Eigen::Index>(i), columns[i]);
  }
  IdentityScores scores;
  scores.recall = matches / std::max(1.0, truth);
  scores.precision = matches / std::max(1.0, estimate);
  scores.idf1 = matches / std::max(1.0, 0.5 * (truth + estimate));
  return scores;
}

}  // namespace cvo
