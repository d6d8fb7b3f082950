// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "experiments/metrics/kitti_ap/average_precision.h"

namespace cvo {

struct ApCounts {
  int true_positives = 0;
  int false_positives = 0;
};

// Labels and detections of a frame that take part at a level, and the overlaps between them. What
// is ignored may be matched, and counts neither as found nor as missed.
class MatchedFrame {
 public:
  // `frame` must outlive it.
  MatchedFrame(const ApFrame& frame, const ApProtocol& protocol, ApLevel level);

  int valid_labels() const;
  // Each label takes the detection of highest score.
  std::vector<double> ScoresOfTruePositives() const;
  // Of detections with at least this score, each label takes that of largest overlap.
  void AddCounts(double least_score, ApCounts& counts) const;

 private:
  struct Label {
    bool ignored;
    std::vector<double> overlaps;  // with each of detections_
  };
  struct Detection {
    bool ignored;
    double score;
    bool in_dont_care;
  };

  std::optional<std::size_t> Largest(const Label& label, const std::vector<bool>& taken,
                                     double least_score) const;

  double least_overlap_;
  std::vector<Label> labels_;
  std::vector<Detection> detections_;
};

}  // namespace cvo
