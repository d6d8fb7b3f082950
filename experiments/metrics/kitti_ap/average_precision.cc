// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/metrics/kitti_ap/average_precision.h"

#include <algorithm>
#include <functional>
#include <numeric>

#include "experiments/metrics/kitti_ap/ap_matching.h"

namespace cvo {
namespace {

// At most 41 scores of true positives whose recalls are nearest to 0, 1/40, ..., 1.
std::vector<double> ScoreThresholds(std::vector<double> scores, int valid_labels) {
  std::sort(scores.begin(), scores.end(), std::greater<>());
  std::vector<double> thresholds;
  double wanted = 0.0;
  for (std::size_t i = 0; i < scores.size(); ++i) {
    const bool is_last = i + 1 == scores.size();
    const double recall = static_cast<double>(i + 1) / valid_labels;
    const double next = is_last ? recall : static_cast<double>(i + 2) / valid_labels;
    if (next - wanted < wanted - recall && !is_last) continue;
    thresholds.push_back(scores[i]);
    wanted += 1.0 / (kRecallSlots - 1.0);
  }
  return thresholds;
}

AveragePrecision EvaluateLevel(const std::vector<ApFrame>& frames, const ApProtocol& protocol,
                               ApLevel level) {
  AveragePrecision result;
  result.level = level;
  std::vector<MatchedFrame> matched;
  std::vector<double> scores;
  for (const ApFrame& frame : frames) {
    matched.emplace_back(frame, protocol, level);
    result.valid_labels += matched.back().valid_labels();
    const std::vector<double> found = matched.back().ScoresOfTruePositives();
    scores.insert(scores.end(), found.begin(), found.end());
  }
  const std::vector<double> thresholds = ScoreThresholds(std::move(scores), result.valid_labels);
  for (std::size_t i = 0; i < std::min(thresholds.size(), kRecallSlots); ++i) {
    ApCounts counts;
    for (const MatchedFrame& frame : matched) frame.AddCounts(thresholds[i], counts);
    const int reported = counts.true_positives + counts.false_positives;
    if (reported > 0) {
      result.precision[i] = static_cast<double>(counts.true_positives) / reported;
    }
  }
  for (std::size_t i = kRecallSlots - 1; i-- > 0;) {
    result.precision[i] = std::max(result.precision[i], result.precision[i + 1]);
  }
  // Divided once: eleven times 1/11 is more than 1.
  for (std::size_t i = 0; i < kRecallSlots; i += 4) result.ap11 += result.precision[i];
  result.ap11 /= 11.0;
  result.ap40 = std::accumulate(result.precision.begin() + 1, result.precision.end(), 0.0) /
                (kRecallSlots - 1.0);
  return result;
}

}  // namespace

std::array<AveragePrecision, 3> EvaluateAp(const std::vector<ApFrame>& frames,
                                           const ApProtocol& protocol) {
  return {EvaluateLevel(frames, protocol, ApLevel::kEasy),
          EvaluateLevel(frames, protocol, ApLevel::kModerate),
          EvaluateLevel(frames, protocol, ApLevel::kHard)};
}

}  // namespace cvo
