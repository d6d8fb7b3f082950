// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// What the images of a few frames contradict in boxes.
#include <Eigen/Geometry>
#include <algorithm>
#include <functional>
#include <string>
#include <vector>

#include "core/base/lists.h"
#include "core/files/text/number.h"
#include "experiments/datasets/plausibility.h"

namespace cvo {
namespace {

// Finds boxes beside what the images show: large ones of the sampled frames without any corner.
void FindEmptyBoxes(const std::vector<SeenFrame>& frames, const char* what,
                    const std::vector<ObjectBox>& boxes, std::vector<std::string>& lines) {
  constexpr double kLargeEnough_px = 30.0;
  constexpr std::size_t kFewest = 4;
  constexpr double kMost = 0.3;  // part of the boxes
  std::size_t large = 0;
  std::size_t empty = 0;
  for (const ObjectBox& box : boxes) {
    const auto seen = std::ranges::find(frames, box.frame, &SeenFrame::frame);
    if (seen == frames.end() || seen->corners.empty() || box.type == "DontCare" ||
        !box.IsInImage() ||
        std::min(box.right_px - box.left_px, box.bottom_px - box.top_px) < kLargeEnough_px) {
      continue;
    }
    ++large;
    empty += std::ranges::none_of(seen->corners, [&](const Eigen::Vector2d& corner) {
      return corner.x() >= box.left_px && corner.x() <= box.right_px && corner.y() >= box.top_px &&
             corner.y() <= box.bottom_px;
    });
  }
  if (large < kFewest || static_cast<double>(empty) <= kMost * static_cast<double>(large)) return;
  lines.push_back(StrCat(what, ": ", empty, " of ", large,
                         " boxes looked at show no corner (pixels of another image?)"));
}

using Box = Eigen::AlignedBox2d;

// The boxes of a frame, turned about the centre of the image where `turn` is -1: the best scored
// ones that are not occluded.
std::vector<Box> BoxesOf(const Sequence& sequence, const std::vector<ObjectBox>& boxes, int frame,
                         const Eigen::Array2d& turn) {
  constexpr std::size_t kMost = 6;
  std::vector<const ObjectBox*> of_frame;
  for (const ObjectBox& box : boxes) {
    if (box.frame != frame || box.type == "DontCare" || !box.IsInImage()) continue;
    if (box.occlusion <= 0 && box.truncation <= 0.0) of_frame.push_back(&box);
  }
  std::ranges::stable_sort(of_frame, std::greater(),
                           [](const ObjectBox* box) { return box->score.value_or(0.0); });
  of_frame.resize(std::min(of_frame.size(), kMost));
  const Eigen::Array2d centre_px =
      0.5 * Eigen::Array2d(sequence.camera.width_px, sequence.camera.height_px);
  std::vector<Box> found;
  for (const ObjectBox* box : of_frame) {
    found.emplace_back();
    for (const auto& corner : {Eigen::Array2d(box->left_px, box->top_px),
                               Eigen::Array2d(box->right_px, box->bottom_px)}) {
      found.back().extend((centre_px + turn * (corner - centre_px)).matrix());
    }
  }
  return found;
}

// How often what boxes show is farther than what is beside them or above them, as no body is.
struct Misfit {
  std::size_t compared = 0;
  std::size_t farther = 0;

  double part() const { return static_cast<double>(farther) / static_cast<double>(compared); }
};

void CompareDepths(const std::vector<Eigen::Vector3d>& points, const std::vector<Box>& boxes,
                   Misfit& misfit) {
  constexpr double kSmallest_px = 30.0;
  constexpr double kMargin = 0.3;  // of the size of the box
  constexpr std::size_t kFewest = 3;
  for (const Box& box : boxes) {
    if (box.sizes().minCoeff() < kSmallest_px) continue;
    const Eigen::Vector2d margin_px = kMargin * box.sizes();
    std::vector<double> inside_px, beside_px, above_px;  // disparities
    for (const Eigen::Vector3d& point : points) {
      const Eigen::Vector2d at_px = point.head<2>();
      const auto has = [&](const Box& other) { return other.contains(at_px); };
      const Eigen::Array2d out_px =
          (box.min() - at_px).cwiseMax(at_px - box.max()).cwiseMax(0.0).array();
      if (has(box)) {
        inside_px.push_back(point.z());
      } else if ((out_px > margin_px.array()).any() || std::ranges::any_of(boxes, has)) {
        continue;
      } else if (out_px.y() == 0.0) {
        beside_px.push_back(point.z());
      } else if (out_px.x() == 0.0 && at_px.y() < box.min().y()) {
        above_px.push_back(point.z());
      }
    }
    for (const std::vector<double>& around_px : {beside_px, above_px}) {
      if (std::min(inside_px.size(), around_px.size()) < kFewest) continue;
      ++misfit.compared;
      misfit.farther += Median(inside_px) <= Median(around_px) ? 1 : 0;
    }
  }
}

// Finds boxes that do not stand out from what surrounds them, or would if they were turned.
void FindMisfits(const Sequence& sequence, const std::vector<SeenFrame>& frames, const char* what,
                 const std::vector<ObjectBox>& boxes, std::vector<std::string>& lines) {
  constexpr std::size_t kFewest = 12;
  constexpr double kMost = 0.25;       // part that is farther
  constexpr double kMostTurned = 0.1;  // and of boxes that another orientation explains
  constexpr double kExplained = 0.5;   // part of that part that may remain
  const auto compare = [&](const Eigen::Array2d& turn) {
    Misfit misfit;
    for (const SeenFrame& seen : frames) {
      CompareDepths(seen.points, BoxesOf(sequence, boxes, seen.frame, turn), misfit);
    }
    return misfit;
  };
  const Misfit given = compare({1.0, 1.0});
  if (given.compared < kFewest || given.part() <= kMostTurned) return;
  std::string better;
  for (const auto& [turn, name] : {std::pair{Eigen::Array2d(1.0, -1.0), "upside down"},
                                   std::pair{Eigen::Array2d(-1.0, 1.0), "mirrored"}}) {
    const Misfit turned = compare(turn);
    if (turned.compared < kFewest || turned.part() >= kExplained * given.part()) continue;
    better = StrCat(" (", FormatFixed(100.0 * turned.part(), 0), " % if they were ", name, ")");
  }
  if (better.empty() && given.part() <= kMost) return;
  lines.push_back(StrCat(what, ": what boxes show is farther than what is beside or above them in ",
                         FormatFixed(100.0 * given.part(), 0), " % of ", given.compared,
                         " comparisons", better));
}

}  // namespace

void FindMisplaced(const Sequence& sequence, const std::vector<SeenFrame>& frames, const char* what,
                   const std::vector<ObjectBox>& boxes, std::vector<std::string>& lines) {
  FindEmptyBoxes(frames, what, boxes, lines);
  FindMisfits(sequence, frames, what, boxes, lines);
}

}  // namespace cvo
