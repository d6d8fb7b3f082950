// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// What the images of a few frames contradict in boxes.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/base/lists.h"
#include "core/files/text/number.h"
#include "experiments/datasets/plausibility.h"

namespace cvo {
namespace {

using Box = ImageBox;

// The boxes of a frame, and the best scored ones of them that are not occluded.
struct BoxesOfFrame {
  std::vector<Box> all, best;
};

using BoxesByFrame = std::map<int, BoxesOfFrame>;

BoxesByFrame SelectBoxes(const std::vector<ObjectBox>& boxes) {
  constexpr std::size_t kMost = 6;
  std::vector<const ObjectBox*> sorted;
  for (const ObjectBox& box : boxes) {
    if (box.type != "DontCare" && box.IsInImage()) sorted.push_back(&box);
  }
  std::ranges::stable_sort(sorted, std::greater(),
                           [](const ObjectBox* box) { return box->score.value_or(0.0); });
  BoxesByFrame by_frame;
  for (const ObjectBox* box : sorted) {
    auto& [all, best] = by_frame[box->frame];
    all.push_back({box->left_px, box->top_px, box->right_px, box->bottom_px});
    const bool whole = box->occlusion <= 0 && box->truncation <= 0.0;
    if (whole && best.size() < kMost) best.push_back(all.back());
  }
  return by_frame;
}

bool IsSmall(const Box& box) { return std::min(box.Width(), box.Height()) < 24.0; }

// The part of pairs of disparities of which the first is the larger.
double NearerPart(const std::vector<double>& inside_px, std::vector<double> around_px) {
  std::ranges::sort(around_px);
  double below = 0.0;
  for (const double px : inside_px) {
    const auto [first, last] = std::equal_range(around_px.begin(), around_px.end(), px);
    below +=
        static_cast<double>(first - around_px.begin()) + 0.5 * static_cast<double>(last - first);
  }
  return below / static_cast<double>(inside_px.size() * around_px.size());
}

// For each of the best boxes, how often what it shows is nearer than what is beside or above it,
// but in no other box: always, of a body that stands alone; in half of the pairs, of a box
// anywhere; never, if nothing is seen in it.
std::vector<double> Fits(const std::vector<Eigen::Vector3d>& points, const BoxesOfFrame& boxes) {
  constexpr double kMargin = 0.3;  // of the size of the box
  constexpr std::size_t kFewest = 3;
  std::vector<double> fits;
  for (const Box& box : boxes.best) {
    if (IsSmall(box)) continue;
    Box around = box.Shrunk(-kMargin);
    around.bottom_px = box.bottom_px;
    std::vector<double> inside_px, around_px;  // disparities
    for (const Eigen::Vector3d& point : points) {
      if (!around.Contains(point.x(), point.y())) continue;
      const auto has = [&](const Box& other) { return other.Contains(point.x(), point.y()); };
      if (has(box)) {
        inside_px.push_back(point.z());
      } else if (std::ranges::none_of(boxes.all, has)) {
        around_px.push_back(point.z());
      }
    }
    if (around_px.size() < kFewest) continue;
    fits.push_back(inside_px.size() < kFewest ? 0.0 : NearerPart(inside_px, around_px));
  }
  return fits;
}

// Where boxes might belong instead: corners times a scale, counted from the other end of the image
// where that is negative, moved by a part of their size, and larger by another at each side.
struct Move {
  const char* name;
  double scale_x, scale_y, by_x, by_y, grow = 0.0;
};
constexpr std::array<Move, 9> kMoves = {{{"mirrored", -1, 1, 0, 0},
                                         {"upside down", 1, -1, 0, 0},
                                         {"farther left", 1, 1, -0.5, 0},
                                         {"farther right", 1, 1, 0.5, 0},
                                         {"higher", 1, 1, 0, -0.5},
                                         {"lower", 1, 1, 0, 0.5},
                                         {"scaled by 2/3", 0.667, 0.667, 0, 0},
                                         {"scaled by 5/4", 1.25, 1.25, 0, 0},
                                         {"twice as large", 1, 1, 0, 0, 0.5}}};

Box Moved(const Box& box, const Move& move, const StereoCamera& camera) {
  const auto along = [](double low, double high, double scale, double by, int size_px) {
    const double shift = (scale < 0.0 ? size_px : 0) + by * (high - low);
    return std::minmax({scale * low + shift, scale * high + shift});
  };
  const auto u = along(box.left_px, box.right_px, move.scale_x, move.by_x, camera.width_px);
  const auto v = along(box.top_px, box.bottom_px, move.scale_y, move.by_y, camera.height_px);
  return ImageBox{u.first, v.first, u.second, v.second}.Shrunk(-move.grow);
}

double MostShared(const Box& box, const std::vector<Box>& others) {
  double most = 0.0;
  for (const Box& other : others) most = std::max(most, IntersectionOverUnion(box, other));
  return most;
}

// How much boxes differ from those `by` frames later; nothing where few frames have any.
std::optional<double> Difference(const BoxesByFrame& boxes, int by) {
  constexpr double kFewest = 12.0;
  double sum = 0.0, count = 0.0;
  for (const auto& [frame, of_frame] : boxes) {
    const auto later = boxes.find(frame + by);
    if (later == boxes.end() || later->second.all.empty()) continue;
    for (const Box& box : of_frame.best) {
      sum += 1.0 - MostShared(box, later->second.all);
      count += 1.0;
    }
  }
  if (count < kFewest) return std::nullopt;
  return sum / count;
}

// Finds boxes that are not in the order of time: those of the next frame are no more like them than
// those of other frames.
void FindShuffled(const BoxesByFrame& boxes, const char* what, std::vector<std::string>& lines) {
  constexpr int kFarthest = 25;
  constexpr double kMostNearer = 0.8, kMostAlike = 0.9, kLeast = 0.25;
  const std::optional<double> next = Difference(boxes, 1);
  if (!next) return;
  double least = *next, most = 0.0;
  int nearest = 1;
  for (int by = 2; by <= kFarthest; ++by) {
    const std::optional<double> there = Difference(boxes, by);
    if (!there) break;
    most = std::max(most, *there);
    if (*there < least) least = *there, nearest = by;
  }
  if (least >= kMostNearer * *next && (most < kLeast || *next < kMostAlike * most)) return;
  lines.push_back(StrCat(what, ": boxes share ", FormatFixed(100.0 * (1.0 - *next), 0),
                         " % with those of the next frame, ", FormatFixed(100.0 * (1.0 - least), 0),
                         " % with those ", nearest, " frames later (another order?)"));
}

constexpr double kSigmas = 2.5;  // what is nearer to the expected is noise

// Finds boxes of other frames than the images: moved as the corners in them move, they share less
// with the boxes of a later frame than unmoved.
void FindOtherFrames(const std::vector<SeenFrame>& frames, const char* what, BoxesByFrame& boxes,
                     std::vector<std::string>& lines) {
  constexpr std::size_t kFewest = 12, kFewestCorners = 3;
  constexpr double kMostLost = 0.025;
  std::vector<double> shared, gains;
  double lost = 0.0;  // less those that won
  for (const SeenFrame& seen : frames) {
    const std::vector<Box>& later = boxes[seen.later].all;
    for (const Box& box : boxes[seen.frame].best) {
      std::vector<double> u_px, v_px;
      for (const auto& [from, to] : seen.moves) {
        if (!box.Contains(from.x(), from.y())) continue;
        u_px.push_back(to.x() - from.x());
        v_px.push_back(to.y() - from.y());
      }
      if (later.empty() || IsSmall(box) || u_px.size() < kFewestCorners) continue;
      const double u = Median(u_px), v = Median(v_px);
      shared.push_back(MostShared(
          {box.left_px + u, box.top_px + v, box.right_px + u, box.bottom_px + v}, later));
      gains.push_back(shared.back() - MostShared(box, later));
      lost += gains.back() < 0.0 ? 1.0 : gains.back() > 0.0 ? -1.0 : 0.0;
    }
  }
  if (shared.size() < kFewest || Median(gains) > -kMostLost ||
      lost < kSigmas * std::sqrt(static_cast<double>(gains.size()))) {
    return;
  }
  lines.push_back(
      StrCat(what, ": boxes that follow the images share ", FormatFixed(100.0 * Median(shared), 0),
             " % with those of later frames, by ", FormatFixed(-100.0 * Median(gains), 0),
             " % less than if they stay (of other frames?)"));
}

}  // namespace

// By a sign test over frames, because the boxes of a frame depend on each other.
void FindMisplaced(const Sequence& sequence, const std::vector<SeenFrame>& frames, const char* what,
                   const std::vector<ObjectBox>& boxes, std::vector<std::string>& lines) {
  constexpr std::size_t kFewest = 12, kFewestFrames = 6;  // boxes, frames
  constexpr double kLeast = 0.65, kBetter = 0.06;         // 0.5 is chance, 0.7 YOLO's
  constexpr double kBetterFrame = 0.05;
  BoxesByFrame by_frame = SelectBoxes(boxes);
  FindShuffled(by_frame, what, lines);
  FindOtherFrames(frames, what, by_frame, lines);
  std::vector<double> all;
  std::vector<std::vector<double>> given;
  for (const SeenFrame& seen : frames) {
    given.push_back(Fits(seen.points, by_frame[seen.frame]));
    all.insert(all.end(), given.back().begin(), given.back().end());
  }
  if (all.empty()) return;
  double most = 0.0;
  std::string better;
  // Tells whether the boxes that `other` gives for a frame fit better.
  const auto compare = [&](const auto& other, double least, const std::string& where) {
    std::vector<double> gains;
    double won = 0.0;  // less those that lost
    for (std::size_t i = 0; i < frames.size(); ++i) {
      const std::vector<double> fits = Fits(frames[i].points, other(frames[i].frame));
      if (given[i].empty() || fits.empty()) continue;
      gains.push_back(MeanOf(fits) - MeanOf(given[i]));
      won += gains.back() > 0.0 ? 1.0 : -1.0;
    }
    if (gains.size() < kFewestFrames || MeanOf(gains) <= std::max(least, most) ||
        won < kSigmas * std::sqrt(static_cast<double>(gains.size()))) {
      return;
    }
    most = MeanOf(gains);
    better = StrCat("; more often by ", FormatFixed(100.0 * most, 0), " % if they were ", where);
  };
  for (const Move& move : kMoves) {
    const auto moved = [&](int frame) {
      BoxesOfFrame boxes_there = by_frame[frame];
      for (Box& box : boxes_there.all) box = Moved(box, move, sequence.camera);
      for (Box& box : boxes_there.best) box = Moved(box, move, sequence.camera);
      return boxes_there;
    };
    compare(moved, kBetter, move.name);
  }
  for (const int by : {3, 5, 10, 20, -3, -5, -10, -20}) {
    const auto of_other = [&](int frame) {
      const auto found = by_frame.find(frame + by);
      return found == by_frame.end() ? BoxesOfFrame() : found->second;
    };
    compare(of_other, kBetterFrame,
            StrCat("those of ", std::abs(by), " frames ", by > 0 ? "later" : "earlier"));
  }
  const double noise =
      kSigmas * std::sqrt(SquaresAroundMean(all)) / static_cast<double>(all.size());
  if (better.empty() && (all.size() < kFewest || MeanOf(all) + noise >= kLeast)) return;
  lines.push_back(StrCat(what, ": what boxes show is nearer than what is around them in only ",
                         FormatFixed(100.0 * MeanOf(all), 0), " % of comparisons", better));
}

}  // namespace cvo
