// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// What the images of a few frames contradict in boxes.
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "core/base/lists.h"
#include "core/files/text/number.h"
#include "experiments/datasets/plausibility.h"

namespace cvo {
namespace {

using Box = Eigen::AlignedBox2d;

// The boxes of a frame: the best scored ones that are not occluded.
std::vector<Box> BoxesOf(const std::vector<ObjectBox>& boxes, int frame) {
  constexpr std::size_t kMost = 6;
  std::vector<const ObjectBox*> of_frame;
  for (const ObjectBox& box : boxes) {
    if (box.frame != frame || box.type == "DontCare" || !box.IsInImage()) continue;
    if (box.occlusion <= 0 && box.truncation <= 0.0) of_frame.push_back(&box);
  }
  std::ranges::stable_sort(of_frame, std::greater(),
                           [](const ObjectBox* box) { return box->score.value_or(0.0); });
  of_frame.resize(std::min(of_frame.size(), kMost));
  std::vector<Box> found;
  for (const ObjectBox* box : of_frame) {
    found.emplace_back(Eigen::Vector2d(box->left_px, box->top_px),
                       Eigen::Vector2d(box->right_px, box->bottom_px));
  }
  return found;
}

// The part of pairs of disparities of which the first is the larger.
double NearerPart(const std::vector<double>& inside_px, std::vector<double> around_px) {
  std::ranges::sort(around_px);
  double below = 0.0;
  for (const double px : inside_px) {
    const auto equal = std::ranges::equal_range(around_px, px);
    below += static_cast<double>(equal.begin() - around_px.begin()) +
             0.5 * static_cast<double>(equal.size());
  }
  return below / static_cast<double>(inside_px.size() * around_px.size());
}

// For each box, how often what it shows is nearer than what is beside or above it: always, of a
// body that stands alone; in half of the pairs, of a box anywhere; never, if nothing is seen in it.
std::vector<double> Fits(const std::vector<Eigen::Vector3d>& points,
                         const std::vector<Box>& boxes) {
  constexpr double kSmallest_px = 24.0, kMargin = 0.3;  // of the size of the box
  constexpr std::size_t kFewest = 3;
  std::vector<double> fits;
  for (const Box& box : boxes) {
    if (box.sizes().minCoeff() < kSmallest_px) continue;
    const Eigen::Vector2d margin_px = kMargin * box.sizes();
    const Box around(box.min() - margin_px, box.max() + Eigen::Vector2d(margin_px.x(), 0.0));
    std::vector<double> inside_px, around_px;  // disparities
    for (const Eigen::Vector3d& point : points) {
      const Eigen::Vector2d at_px = point.head<2>();
      if (!around.contains(at_px)) continue;
      const auto has = [&](const Box& other) { return other.contains(at_px); };
      if (has(box)) {
        inside_px.push_back(point.z());
      } else if (std::ranges::none_of(boxes, has)) {
        around_px.push_back(point.z());
      }
    }
    if (around_px.size() < kFewest) continue;
    fits.push_back(inside_px.size() < kFewest ? 0.0 : NearerPart(inside_px, around_px));
  }
  return fits;
}

// Where boxes might belong instead: corners times a scale, counted from the other end of the image
// where that is negative, and moved by a part of their size.
struct Move {
  const char* name;
  double scale_x, scale_y, by_x, by_y;
};
constexpr std::array<Move, 10> kMoves = {{{"mirrored", -1, 1, 0, 0},
                                          {"upside down", 1, -1, 0, 0},
                                          {"farther left", 1, 1, -0.5, 0},
                                          {"farther right", 1, 1, 0.5, 0},
                                          {"higher", 1, 1, 0, -0.5},
                                          {"lower", 1, 1, 0, 0.5},
                                          {"scaled by 2/3", 0.667, 0.667, 0, 0},
                                          {"scaled by 4/5", 0.8, 0.8, 0, 0},
                                          {"scaled by 5/4", 1.25, 1.25, 0, 0},
                                          {"scaled by 3/2", 1.5, 1.5, 0, 0}}};

Box Moved(const Box& box, const Move& move, const StereoCamera& camera) {
  const Eigen::Array2d scale(move.scale_x, move.scale_y);
  const Eigen::Array2d shift_px =
      Eigen::Array2d(camera.width_px, camera.height_px) * (scale < 0.0).cast<double>() +
      Eigen::Array2d(move.by_x, move.by_y) * box.sizes().array();
  Box moved((scale * box.min().array() + shift_px).matrix());
  return moved.extend((scale * box.max().array() + shift_px).matrix());
}

}  // namespace

// By a sign test over frames, because the boxes of a frame depend on each other.
void FindMisplaced(const Sequence& sequence, const std::vector<SeenFrame>& frames, const char* what,
                   const std::vector<ObjectBox>& boxes, std::vector<std::string>& lines) {
  constexpr std::size_t kFewest = 12, kFewestFrames = 6;          // boxes, frames
  constexpr double kLeast = 0.55, kBetter = 0.06, kSigmas = 2.0;  // 0.5 is chance
  std::vector<double> all;
  std::vector<std::vector<double>> given;
  for (const SeenFrame& seen : frames) {
    given.push_back(Fits(seen.points, BoxesOf(boxes, seen.frame)));
    all.insert(all.end(), given.back().begin(), given.back().end());
  }
  if (all.empty()) return;
  double most = kBetter;
  std::string better;
  for (const Move& move : kMoves) {
    std::vector<double> gains;
    double won = 0.0;  // less those that lost
    for (std::size_t i = 0; i < frames.size(); ++i) {
      std::vector<Box> moved = BoxesOf(boxes, frames[i].frame);
      for (Box& box : moved) box = Moved(box, move, sequence.camera);
      const std::vector<double> fits = Fits(frames[i].points, moved);
      if (given[i].empty() || fits.empty()) continue;
      gains.push_back(MeanOf(fits) - MeanOf(given[i]));
      won += gains.back() > 0.0 ? 1.0 : -1.0;
    }
    if (gains.size() < kFewestFrames || MeanOf(gains) <= most ||
        won < kSigmas * std::sqrt(static_cast<double>(gains.size()))) {
      continue;
    }
    most = MeanOf(gains);
    better =
        StrCat("; more often by ", FormatFixed(100.0 * most, 0), " % if they were ", move.name);
  }
  if (better.empty() && (all.size() < kFewest || MeanOf(all) >= kLeast)) return;
  lines.push_back(StrCat(what, ": what boxes show is nearer than what is around them in only ",
                         FormatFixed(100.0 * MeanOf(all), 0), " % of comparisons", better));
}

}  // namespace cvo
