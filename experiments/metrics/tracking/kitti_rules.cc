// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/metrics/tracking/kitti_rules.h"

#include <algorithm>
#include <map>
#include <set>

#include "core/association/assignment.h"
#include "core/base/error.h"
#include "experiments/metrics/kitti_ap/box_class.h"

namespace cvo {
namespace {

using Boxes = std::vector<const ObjectBox*>;

constexpr double kLeastSimilarity = 0.5;

bool Counts(const ObjectBox& label, const std::string& category) {
  constexpr int kMostOcclusion = 2;
  constexpr double kMostTruncation = kSimilaritySlack;
  return IsOfClass(label, category) && label.occlusion <= kMostOcclusion &&
         label.truncation <= kMostTruncation;
}

// Matches reported boxes in the image. Returns, per reported box, the true box or nullptr.
Boxes MatchInImage(const Boxes& labels, const Boxes& detections) {
  Eigen::MatrixXd cost(labels.size(), detections.size());
  for (std::size_t i = 0; i < labels.size(); ++i) {
    for (std::size_t j = 0; j < detections.size(); ++j) {
      const double overlap = IntersectionOverUnion(BoxSpace::kImage, *labels[i], *detections[j]);
      cost(i, j) = overlap < kLeastSimilarity - kSimilaritySlack ? 0.0 : -overlap;
    }
  }
  Boxes matched(detections.size(), nullptr);
  const std::vector<int> columns = Assign(cost);
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (columns[i] < 0 || !(-cost(i, columns[i]) > kSimilaritySlack)) continue;
    matched[static_cast<std::size_t>(columns[i])] = labels[i];
  }
  return matched;
}

bool IsForgiven(const ObjectBox& detection, const std::vector<ObjectBox>& labels) {
  constexpr double kLeastHeight_px = 25.0;
  if (detection.bottom_px - detection.top_px <= kLeastHeight_px + kSimilaritySlack) return true;
  return std::any_of(labels.begin(), labels.end(), [&](const ObjectBox& label) {
    return IsDontCare(label) && ShareInside(detection, label) > kLeastSimilarity + kSimilaritySlack;
  });
}

Boxes CountedDetections(const ApFrame& frame, const std::string& category) {
  Boxes labels;
  for (const ObjectBox& label : frame.labels) {
    if (IsOfClass(label, category) || IsNeighbour(label, category)) labels.push_back(&label);
  }
  Boxes detections;
  for (const ObjectBox& box : frame.detections) {
    if (IsOfClass(box, category)) detections.push_back(&box);
  }
  const Boxes matched = MatchInImage(labels, detections);
  Boxes counted;
  for (std::size_t j = 0; j < detections.size(); ++j) {
    const bool out = matched[j] != nullptr ? !Counts(*matched[j], category)
                                           : IsForgiven(*detections[j], frame.labels);
    if (!out) counted.push_back(detections[j]);
  }
  return counted;
}

// Maps the track ids of a file to identities without gaps.
class Identities {
 public:
  std::vector<int> Of(const Boxes& boxes, const char* where) {
    std::set<int> seen;
    std::vector<int> ids;
    for (const ObjectBox* box : boxes) {
      if (!seen.insert(box->track).second) {
        ThrowError(where, StrCat("two boxes of track ", box->track, " in frame ", box->frame),
                   "one");
      }
      ids.push_back(ids_.emplace(box->track, static_cast<int>(ids_.size())).first->second);
    }
    return ids;
  }
  int count() const { return static_cast<int>(ids_.size()); }

 private:
  std::map<int, int> ids_;
};

}  // namespace

TrackedSequence CountedBoxes(const std::vector<ApFrame>& frames, const std::string& category,
                             BoxSpace space) {
  TrackedSequence sequence;
  Identities true_ids;
  Identities reported_ids;
  for (const ApFrame& frame : frames) {
    Boxes labels;
    for (const ObjectBox& label : frame.labels) {
      if (Counts(label, category)) labels.push_back(&label);
    }
    const Boxes detections = CountedDetections(frame, category);
    TrackedFrame tracked{true_ids.Of(labels, "labels"), reported_ids.Of(detections, "detections"),
                         Eigen::MatrixXd(labels.size(), detections.size())};
    for (std::size_t i = 0; i < labels.size(); ++i) {
      for (std::size_t j = 0; j < detections.size(); ++j) {
        tracked.similarity(i, j) = IntersectionOverUnion(space, *labels[i], *detections[j]);
      }
    }
    sequence.frames.push_back(std::move(tracked));
  }
  sequence.truth_count = true_ids.count();
  sequence.estimate_count = reported_ids.count();
  return sequence;
}

}  // namespace cvo
