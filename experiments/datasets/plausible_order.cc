// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// Images that are not in the order of time.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "core/base/lists.h"
#include "core/files/text/number.h"
#include "experiments/datasets/images.h"
#include "experiments/datasets/plausibility.h"

namespace cvo {
namespace {

// Small copies of the left images without their means, as exposures vary.
class Outlines {
 public:
  explicit Outlines(const Sequence& sequence) : sequence_(sequence) {}

  // By how much two frames differ; endlessly if one is damaged.
  double Apart(std::size_t one, std::size_t other) {
    const cv::Mat a = Find(one), b = Find(other);
    if (a.empty() || a.size() != b.size()) return std::numeric_limits<double>::infinity();
    return cv::norm(a, b, cv::NORM_L1);
  }

 private:
  const cv::Mat& Find(std::size_t index) {
    const auto [found, is_new] = outlines_.try_emplace(index);
    cv::Mat& image = found->second;
    if (is_new) image = LoadFrameImage(sequence_, index, 0).grey;
    if (!is_new || image.empty()) return image;
    const double scale = std::min(0.125, 160.0 / sequence_.camera.width_px);
    cv::resize(image, image, cv::Size(), scale, scale, cv::INTER_AREA);
    image.convertTo(image, CV_32F, 1.0, -cv::mean(image)[0]);
    return image;
  }

  const Sequence& sequence_;
  std::map<std::size_t, cv::Mat> outlines_;
};

// Finds neighbours that are swapped: of four frames in a row, neighbours would differ less in
// another order. Of a camera that does not move, all orders are about equally good.
bool FindSwapped(const std::vector<std::size_t>& frames, Outlines& outlines,
                 std::vector<std::string>& lines) {
  double rows = 0.0, in_order = 0.0, given = 0.0, best = 0.0;
  for (std::size_t at = 0; at + 3 < frames.size(); ++at) {
    if (frames[at + 3] != frames[at] + 3) continue;
    std::array<std::size_t, 4> row = {frames[at], frames[at + 1], frames[at + 2], frames[at + 3]};
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
bool FindElsewhere(const std::vector<std::size_t>& frames, Outlines& outlines,
                   std::vector<std::string>& lines) {
  constexpr double kMostNearer = 1.15, kMost = 0.15;
  constexpr std::size_t kNear = 3;  // frames, within which speeds vary
  double looked = 0.0, elsewhere = 0.0;
  for (std::size_t at = 1; at + 1 < frames.size(); ++at) {
    const std::size_t frame = frames[at];
    if (frames[at - 1] + 1 != frame || frames[at + 1] != frame + 1) continue;
    double nearest = std::numeric_limits<double>::infinity();
    for (const std::size_t other : frames) {
      if (std::max(frame, other) - std::min(frame, other) > kNear) {
        nearest = std::min(nearest, outlines.Apart(frame, other));
      }
    }
    const double step =
        std::max(outlines.Apart(frame, frame - 1), outlines.Apart(frame, frame + 1));
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
void FindCut(const Sequence& sequence, const std::vector<std::size_t>& frames, Outlines& outlines,
             std::vector<std::string>& lines) {
  constexpr double kMost = 3.0;
  std::vector<double> steps;
  for (std::size_t at = 1; at < frames.size(); ++at) {
    const bool next = frames[at] == frames[at - 1] + 1;
    steps.push_back(next ? outlines.Apart(frames[at - 1], frames[at]) : 0.0);
  }
  for (std::size_t i = 2; i + 2 < steps.size(); ++i) {
    const double around = std::max({steps[i - 2], steps[i - 1], steps[i + 1], steps[i + 2]});
    if (!std::isfinite(steps[i]) || steps[i] <= kMost * around) continue;
    lines.push_back(StrCat("images, frame ", sequence.first_frame + static_cast<int>(frames[i + 1]),
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
  Outlines outlines(sequence);
  if (FindSwapped(frames, outlines, lines) || FindElsewhere(frames, outlines, lines)) return;
  FindCut(sequence, frames, outlines, lines);
}

}  // namespace cvo
