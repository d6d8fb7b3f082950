// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/metrics/kitti_ap/ap_matching.h"

#include <algorithm>
#include <cmath>

#include "experiments/metrics/kitti_ap/box_class.h"

namespace cvo {
namespace {

// Beyond any of them, a label is ignored at the level.
struct LevelLimits {
  double least_height_px;
  int most_occlusion;
  double most_truncation;
};
LevelLimits LimitsOf(ApLevel level) {
  constexpr std::array<LevelLimits, 3> kLimits = {
      {{40.0, 0, 0.15}, {25.0, 1, 0.30}, {25.0, 2, 0.50}}};
  return kLimits[static_cast<std::size_t>(level)];
}

bool Exceeds(const ObjectBox& label, const LevelLimits& limits, TruncationRule truncation) {
  return label.occlusion > limits.most_occlusion ||
         (truncation == TruncationRule::kApplied && label.truncation > limits.most_truncation) ||
         label.bottom_px - label.top_px < limits.least_height_px;
}

}  // namespace

MatchedFrame::MatchedFrame(const ApFrame& frame, const ApProtocol& protocol, ApLevel level)
    : least_overlap_(protocol.least_overlap) {
  const LevelLimits limits = LimitsOf(level);
  const bool spares =
      protocol.space == BoxSpace::kImage || protocol.dont_care == DontCareRule::kAll;
  std::vector<const ObjectBox*> boxes;
  for (const ObjectBox& box : frame.detections) {
    // Small boxes of any class are ignored; the devkit cuts their height to whole pixels.
    const bool small = std::trunc(std::abs(box.bottom_px - box.top_px)) < limits.least_height_px;
    if (!small && !IsOfClass(box, protocol.category)) continue;
    const bool in_dont_care =
        spares &&
        std::any_of(frame.labels.begin(), frame.labels.end(), [&](const ObjectBox& label) {
          return IsDontCare(label) && ShareInside(box, label) > least_overlap_;
        });
    boxes.push_back(&box);
    detections_.push_back({small, box.score.value_or(1.0), in_dont_care});
  }
  for (const ObjectBox& label : frame.labels) {
    const bool neighbour = IsNeighbour(label, protocol.category);
    if (!neighbour && !IsOfClass(label, protocol.category)) continue;
    Label kept{neighbour || Exceeds(label, limits, protocol.truncation), {}};
    for (const ObjectBox* box : boxes) {
      kept.overlaps.push_back(IntersectionOverUnion(protocol.space, *box, label));
    }
    labels_.push_back(std::move(kept));
  }
}

int MatchedFrame::valid_labels() const {
  return static_cast<int>(std::count_if(labels_.begin(), labels_.end(),
                                        [](const Label& label) { return !label.ignored; }));
}

std::vector<double> MatchedFrame::ScoresOfTruePositives() const {
  std::vector<bool> taken(detections_.size(), false);
  std::vector<double> scores;
  for (const Label& label : labels_) {
    std::optional<std::size_t> best;
    for (std::size_t j = 0; j < detections_.size(); ++j) {
      if (taken[j] || !(label.overlaps[j] > least_overlap_)) continue;
      if (!best || detections_[j].score > detections_[*best].score) best = j;
    }
    if (!best) continue;
    taken[*best] = true;
    if (!label.ignored && !detections_[*best].ignored) scores.push_back(detections_[*best].score);
  }
  return scores;
}

// The largest overlap of a detection that is not ignored; without one, the first that is.
std::optional<std::size_t> MatchedFrame::Largest(const Label& label, const std::vector<bool>& taken,
                                                 double least_score) const {
  std::optional<std::size_t> best;
  for (std::size_t j = 0; j < detections_.size(); ++j) {
    const Detection& detection = detections_[j];
    if (taken[j] || detection.score < least_score || !(label.overlaps[j] > least_overlap_))
      continue;
    const bool replaces = best && !detection.ignored &&
                          (detections_[*best].ignored || label.overlaps[j] > label.overlaps[*best]);
    if (!best || replaces) best = j;
  }
  return best;
}

void MatchedFrame::AddCounts(double least_score, ApCounts& counts) const {
  std::vector<bool> taken(detections_.size(), false);
  for (const Label& label : labels_) {
    const std::optional<std::size_t> best = Largest(label, taken, least_score);
    if (!best) continue;
    taken[*best] = true;
    if (!label.ignored && !detections_[*best].ignored) ++counts.true_positives;
  }
  for (std::size_t j = 0; j < detections_.size(); ++j) {
    const Detection& detection = detections_[j];
    if (taken[j] || detection.ignored || detection.score < least_score) continue;
    if (!detection.in_dont_care) ++counts.false_positives;
  }
}

}  // namespace cvo
