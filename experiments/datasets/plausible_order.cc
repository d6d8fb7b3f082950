// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// Images that are not in the order of time.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <utility>
#include <vector>

#include "core/base/lists.h"
#include "core/files/text/number.h"
#include "experiments/datasets/images.h"
#include "experiments/datasets/plausibility.h"

namespace cvo {
namespace {

// A small copy of a left image without its mean, as exposures vary; empty if it is damaged.
cv::Mat Outline(const Sequence& sequence, std::size_t index) {
  const double scale = std::min(0.125, 160.0 / sequence.camera.width_px);
  cv::Mat image = LoadFrameImage(sequence, index, 0).grey;
  if (image.empty()) return image;
  cv::resize(image, image, cv::Size(), scale, scale, cv::INTER_AREA);
  image.convertTo(image, CV_32F, 1.0, -cv::mean(image)[0]);
  return image;
}

// Frames, and by how much any two of them differ: endlessly if one is damaged.
struct Outlines {
  std::vector<std::size_t> frames;
  cv::Mat_<double> apart;

  // Whether the frames from `at` to `at + count - 1` follow each other.
  bool InARow(std::size_t at, std::size_t count) const {
    return at + count <= frames.size() && frames[at + count - 1] == frames[at] + count - 1;
  }
  double Apart(std::size_t a, std::size_t b) const {
    return apart(static_cast<int>(a), static_cast<int>(b));
  }
};

Outlines Compare(const Sequence& sequence, std::vector<std::size_t> frames) {
  const auto count = static_cast<int>(frames.size());
  cv::Mat_<double> apart(count, count, std::numeric_limits<double>::infinity());
  std::vector<cv::Mat> images;
  for (int i = 0; i < count; ++i) {
    images.push_back(Outline(sequence, frames[static_cast<std::size_t>(i)]));
    for (int k = 0; k < i; ++k) {
      const cv::Mat& other = images[static_cast<std::size_t>(k)];
      if (images.back().empty() || images.back().size() != other.size()) continue;
      apart(i, k) = apart(k, i) = cv::norm(images.back(), other, cv::NORM_L1);
    }
  }
  return {std::move(frames), std::move(apart)};
}

// Finds neighbours that are swapped: of four frames in a row, neighbours would differ less in
// another order. Of a camera that does not move, all orders are about equally good.
bool FindSwapped(const Outlines& outlines, std::vector<std::string>& lines) {
  double rows = 0.0, in_order = 0.0, given = 0.0, best = 0.0;
  for (std::size_t at = 0; at < outlines.frames.size(); ++at) {
    if (!outlines.InARow(at, 4)) continue;
    std::array<std::size_t, 4> row = {at, at + 1, at + 2, at + 3};
    std::vector<double> lengths;
    do {
      lengths.push_back(outlines.Apart(row[0], row[1]) + outlines.Apart(row[1], row[2]) +
                        outlines.Apart(row[2], row[3]));
    } while (std::ranges::next_permutation(row).found);
    const double shortest = std::ranges::min(lengths);
    if (!std::isfinite(shortest)) continue;
    rows += 1.0;
    in_order += lengths[0] <= shortest ? 1.0 : 0.0;
    given += lengths[0];
    best += shortest;
  }
  constexpr double kFewest = 3.0, kMostBetter = 1.05;
  if (rows < kFewest || 2.0 * in_order >= rows || given <= kMostBetter * best) return false;
  lines.push_back(StrCat("images: in ", rows - in_order, " of ", rows,
                         " places, four frames in a row would differ less in another order"));
  return true;
}

// Finds frames that are more like one that is elsewhere than like a neighbour.
bool FindElsewhere(const Outlines& outlines, std::vector<std::string>& lines) {
  constexpr double kMostNearer = 1.15, kMost = 0.15;
  constexpr std::size_t kNear = 3;  // frames, within which speeds vary
  const std::vector<std::size_t>& frames = outlines.frames;
  double looked = 0.0, elsewhere = 0.0;
  for (std::size_t at = 1; at + 1 < frames.size(); ++at) {
    if (!outlines.InARow(at - 1, 3)) continue;
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t other = 0; other < frames.size(); ++other) {
      if (std::max(frames[at], frames[other]) - std::min(frames[at], frames[other]) > kNear) {
        nearest = std::min(nearest, outlines.Apart(at, other));
      }
    }
    const double step = std::max(outlines.Apart(at, at - 1), outlines.Apart(at, at + 1));
    if (!std::isfinite(step) || !std::isfinite(nearest)) continue;
    looked += 1.0;
    elsewhere += step > kMostNearer * nearest ? 1.0 : 0.0;
  }
  if (elsewhere <= kMost * looked) return false;
  lines.push_back(StrCat("images: ", elsewhere, " of ", looked,
                         " frames are more like one elsewhere than like the one beside them "
                         "(another order, such as 1, 10, 11, 2?)"));
  return true;
}

// Finds a frame that differs from the one before by much more than those around it do.
void FindCut(const Outlines& outlines, int first_frame, std::vector<std::string>& lines) {
  constexpr double kMost = 3.0;
  std::vector<double> steps;
  for (std::size_t at = 0; at + 1 < outlines.frames.size(); ++at) {
    steps.push_back(outlines.InARow(at, 2) ? outlines.Apart(at, at + 1) : 0.0);
  }
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const double around = LargestAround(steps, i);
    if (!std::isfinite(steps[i]) || steps[i] <= kMost * around) continue;
    lines.push_back(StrCat("images, frame ", first_frame + static_cast<int>(outlines.frames[i + 1]),
                           ": it differs from the one before by ",
                           FormatFixed(steps[i] / around, 1),
                           " times as much as those around it (another sequence?)"));
    return;
  }
}

}  // namespace

void FindDisorder(const Sequence& sequence, std::vector<std::string>& lines) {
  constexpr std::size_t kInARow = 25;
  const std::size_t count = sequence.images.size();
  std::vector<std::size_t> frames;
  for (std::size_t i = 0; i < count; ++i) {
    const bool middle = i + 5 >= count / 2 && i < count / 2 + kInARow;
    if (i < kInARow || middle || i + kInARow >= count) frames.push_back(i);
  }
  const Outlines outlines = Compare(sequence, std::move(frames));
  if (FindSwapped(outlines, lines) || FindElsewhere(outlines, lines)) return;
  FindCut(outlines, sequence.first_frame, lines);
}

}  // namespace cvo
