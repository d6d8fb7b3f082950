// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/metrics/boxes/average_precision.h"

#include <Eigen/Core>
#include <algorithm>
#include <cctype>
#include <cmath>
#include <functional>
#include <numeric>
#include <optional>
#include <vector>

#include "core/base/error.h"

namespace cvo {

namespace {

bool SameText(const std::string& a, const std::string& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](unsigned char x, unsigned char y) {
    return std::tolower(x) == std::tolower(y);
  });
}

}  // namespace

bool IsOfClass(const ObjectBox& box, const std::string& category) {
  return SameText(box.type, category);
}

bool IsNeighbour(const ObjectBox& box, const std::string& category) {
  if (SameText(category, "car")) return SameText(box.type, "van");
  return SameText(category, "pedestrian") &&
         (SameText(box.type, "person_sitting") || SameText(box.type, "person"));
}

bool IsDontCare(const ObjectBox& label) { return SameText(label.type, "dontcare"); }

namespace {

using Polygon = std::vector<Eigen::Vector2d>;
using Box3d = ObjectBox::Box3d;

double Overlap(double low_a, double high_a, double low_b, double high_b) {
  return std::max(0.0, std::min(high_a, high_b) - std::max(low_a, low_b));
}

double AreaPx2(const ObjectBox& box) {
  return std::max(0.0, box.right_px - box.left_px) * std::max(0.0, box.bottom_px - box.top_px);
}

double IntersectionPx2(const ObjectBox& a, const ObjectBox& b) {
  return Overlap(a.left_px, a.right_px, b.left_px, b.right_px) *
         Overlap(a.top_px, a.bottom_px, b.top_px, b.bottom_px);
}

double Cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

// Corners in x-z, ordered so that the inside is to the left of each side. At heading 0 the length
// is along x.
Polygon Footprint(const Box3d& box) {
  const Eigen::Vector2d center(box.bottom_in_camera.x(), box.bottom_in_camera.z());
  const double c = std::cos(box.heading_rad);
  const double s = std::sin(box.heading_rad);
  const Eigen::Vector2d along = 0.5 * box.length_m * Eigen::Vector2d(c, -s);
  const Eigen::Vector2d across = 0.5 * box.width_m * Eigen::Vector2d(s, c);
  return {center + along + across, center - along + across, center - along - across,
          center + along - across};
}

// Returns the part of a convex polygon to the left of the line from `from` to `to`.
Polygon Clip(const Polygon& polygon, const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
  Polygon kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Eigen::Vector2d& a = polygon[i];
    const Eigen::Vector2d& b = polygon[(i + 1) % polygon.size()];
    const double at_a = Cross(to - from, a - from);
    const double at_b = Cross(to - from, b - from);
    if (at_a >= 0.0) kept.push_back(a);
    if ((at_a > 0.0 && at_b < 0.0) || (at_a < 0.0 && at_b > 0.0)) {
      kept.push_back(a + at_a / (at_a - at_b) * (b - a));
    }
  }
  return kept;
}

double Area(const Polygon& polygon) {
  double twice = 0.0;
  for (std::size_t i = 2; i < polygon.size(); ++i) {
    twice += Cross(polygon[i - 1] - polygon[0], polygon[i] - polygon[0]);
  }
  return 0.5 * std::abs(twice);
}

double IntersectionOnGround_m2(const Box3d& a, const Box3d& b) {
  Polygon common = Footprint(a);
  const Polygon sides = Footprint(b);
  for (std::size_t i = 0; i < sides.size() && !common.empty(); ++i) {
    common = Clip(common, sides[i], sides[(i + 1) % sides.size()]);
  }
  return Area(common);
}

double Ratio(double intersection, double of) { return of > 0.0 ? intersection / of : 0.0; }

double OverUnion(double intersection, double a, double b) {
  return Ratio(intersection, a + b - intersection);
}

}  // namespace

double IntersectionOverUnion(BoxSpace space, const ObjectBox& a, const ObjectBox& b) {
  if (space == BoxSpace::kImage) return OverUnion(IntersectionPx2(a, b), AreaPx2(a), AreaPx2(b));
  if (!a.box3d || !b.box3d) return 0.0;
  const double ground_m2 = IntersectionOnGround_m2(*a.box3d, *b.box3d);
  const double area_a_m2 = a.box3d->length_m * a.box3d->width_m;
  const double area_b_m2 = b.box3d->length_m * b.box3d->width_m;
  if (space == BoxSpace::kBirdsEye) return OverUnion(ground_m2, area_a_m2, area_b_m2);
  const double bottom_a = a.box3d->bottom_in_camera.y();  // y points down
  const double bottom_b = b.box3d->bottom_in_camera.y();
  const double height_m =
      Overlap(bottom_a - a.box3d->height_m, bottom_a, bottom_b - b.box3d->height_m, bottom_b);
  return OverUnion(ground_m2 * height_m, area_a_m2 * a.box3d->height_m,
                   area_b_m2 * b.box3d->height_m);
}

double ShareInside(const ObjectBox& detection, const ObjectBox& region) {
  return Ratio(IntersectionPx2(detection, region), AreaPx2(detection));
}

namespace {

struct ApCounts {
  int true_positives = 0;
  int false_positives = 0;
};

// The labels and detections of a frame that take part at a level, and the overlaps between them.
// Ignored ones may be matched, but count neither as found nor as missed nor as false.
class MatchedFrame {
 public:
  MatchedFrame(const ApFrame& frame, const ApProtocol& protocol, ApLevel level);

  int valid_labels() const;
  // Each label is matched with the detection of highest score.
  std::vector<double> ScoresOfTruePositives() const;
  // Each label is matched with the detection of largest overlap among those with at least this
  // score.
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

// A label beyond any of these limits is ignored at the level.
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

MatchedFrame::MatchedFrame(const ApFrame& frame, const ApProtocol& protocol, ApLevel level)
    : least_overlap_(protocol.least_overlap) {
  const LevelLimits limits = LimitsOf(level);
  std::vector<const ObjectBox*> boxes;
  for (const ObjectBox& box : frame.detections) {
    // Small boxes of any class are ignored; like the devkit, this truncates their height to whole
    // pixels.
    const bool in_3d = protocol.space != BoxSpace::kImage && !box.IsInImage();
    const bool small =
        !in_3d && std::trunc(std::abs(box.bottom_px - box.top_px)) < limits.least_height_px;
    if (!small && !IsOfClass(box, protocol.category)) continue;
    const bool in_dont_care =
        protocol.space == BoxSpace::kImage &&
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

// Returns the detection of largest overlap that is not ignored; if there is none, the first ignored
// one.
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

// Returns at most 41 scores of true positives, those whose recalls are nearest to 0, 1/40, ..., 1;
// of fewer labels than 41, those that first reach each of these recalls.
std::vector<double> ScoreThresholds(std::vector<double> scores, int valid_labels) {
  std::sort(scores.begin(), scores.end(), std::greater<>());
  std::vector<double> thresholds;
  const auto labels = static_cast<std::size_t>(valid_labels);
  for (std::size_t slot = 0; labels < kRecallSlots && slot < kRecallSlots; ++slot) {
    constexpr std::size_t kSteps = kRecallSlots - 1;
    const std::size_t rank = std::max<std::size_t>(1, (slot * labels + kSteps - 1) / kSteps);
    if (rank <= scores.size()) thresholds.push_back(scores[rank - 1]);
  }
  if (labels < kRecallSlots) return thresholds;
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
  // The sum is divided once, because eleven times 1/11 is more than 1 in doubles.
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
