// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/features/orb/corner_score.h"

#include <algorithm>
#include <cstring>

#include "core/base/error.h"
#include "core/features/processor.h"

namespace cvo {
namespace {

constexpr int kRing = 16;
constexpr int kRadius = 3;
constexpr int kRingX[kRing] = {0, 1, 2, 3, 3, 3, 2, 1, 0, -1, -2, -3, -3, -3, -2, -1};
constexpr int kRingY[kRing] = {3, 3, 2, 1, 0, -1, -2, -3, -3, -3, -2, -1, 0, 1, 2, 3};

using Byte = std::uint8_t;

// Written so that the compiler vectorises them as byte-wise minima, maxima and differences.
[[gnu::always_inline]] inline Byte Min(Byte a, Byte b) { return a < b ? a : b; }
[[gnu::always_inline]] inline Byte Max(Byte a, Byte b) { return a > b ? a : b; }
[[gnu::always_inline]] inline Byte Less(Byte a, Byte b) { return static_cast<Byte>(a - b); }

// Returns the maximum over the 16 arcs of 9 pixels of the smallest d in the arc. Arcs are evaluated
// in pairs that share 8 pixels.
[[gnu::always_inline]] inline Byte BestArc(const Byte (&d)[kRing]) {
  Byte pairs[8];
  Byte fours[8];
  for (int i = 0; i < 8; ++i) pairs[i] = Min(d[2 * i + 1], d[(2 * i + 2) % kRing]);
  for (int i = 0; i < 8; ++i) fours[i] = Min(pairs[i], pairs[(i + 1) % 8]);
  Byte best = 0;
  for (int i = 0; i < 8; ++i) {
    const Byte eight = Min(fours[i], fours[(i + 2) % 8]);
    best = Max(best, Min(eight, Max(d[2 * i], d[(2 * i + 9) % kRing])));
  }
  return best;
}

CVO_FOR_EACH_PROCESSOR
void ScoreRow(const Byte* row, const std::ptrdiff_t (&ring)[kRing], int count,
              Byte* __restrict scores) {
  for (int x = 0; x < count; ++x) {
    const Byte centre = row[x];
    Byte brighter[kRing];
    Byte darker[kRing];
    for (int k = 0; k < kRing; ++k) {
      const Byte value = row[x + ring[k]];
      const Byte larger = Max(value, centre);
      brighter[k] = Less(larger, centre);
      darker[k] = Less(larger, value);
    }
    scores[x] = Max(BestArc(brighter), BestArc(darker));
  }
}

// Sets marks[x] to the score at x if it is a maximum above the threshold, else to 0.
void MarkMaxima(const cv::Mat& scores, int y, int threshold, int first, int last,
                std::vector<Byte>& marks) {
  const Byte* above = scores.ptr<Byte>(y - 1);
  const Byte* row = scores.ptr<Byte>(y);
  const Byte* below = scores.ptr<Byte>(y + 1);
  const Byte least = static_cast<Byte>(threshold);
  Byte* __restrict out = marks.data();
  for (int x = first; x < last; ++x) {
    const Byte before = Max(Max(above[x - 1], above[x]), Max(above[x + 1], row[x - 1]));
    const Byte after = Max(Max(row[x + 1], below[x - 1]), Max(below[x], below[x + 1]));
    const Byte score = row[x];
    const bool is_corner = (score > Max(before, least)) & (score >= after);
    out[x] = is_corner ? score : Byte{0};
  }
}

void AppendMarked(const std::vector<Byte>& marks, int y, int first, int last,
                  std::vector<Corner>& corners) {
  int x = first;
  while (x < last) {
    std::uint64_t eight = 0;
    if (x + 8 <= last) {
      std::memcpy(&eight, &marks[x], 8);
      if (eight == 0) {
        x += 8;
        continue;
      }
    }
    const int end = std::min(x + 8, last);
    for (; x < end; ++x) {
      if (marks[x] != 0) corners.push_back({x, y, marks[x]});
    }
  }
}

}  // namespace

void ComputeFastScores(const cv::Mat& image, cv::Mat& scores) {
  Require(image.type() == CV_8UC1 && scores.type() == CV_8UC1 && image.size() == scores.size(),
          "ComputeFastScores: needs two CV_8UC1 images of one size");
  std::ptrdiff_t ring[kRing];
  for (int k = 0; k < kRing; ++k) {
    ring[k] = kRingY[k] * static_cast<std::ptrdiff_t>(image.step) + kRingX[k];
  }
  const int inner = image.cols - 2 * kRadius;
  for (int y = 0; y < image.rows; ++y) {
    Byte* out = scores.ptr<Byte>(y);
    if (inner <= 0 || y < kRadius || y >= image.rows - kRadius) {
      std::memset(out, 0, static_cast<std::size_t>(image.cols));
      continue;
    }
    std::memset(out, 0, kRadius);
    ScoreRow(image.ptr<Byte>(y) + kRadius, ring, inner, out + kRadius);
    std::memset(out + kRadius + inner, 0, kRadius);
  }
}

std::vector<Corner> FindMaxima(const cv::Mat& scores, int border_px, int threshold) {
  const int last_x = scores.cols - border_px;
  const int last_y = scores.rows - border_px;
  std::vector<Corner> maxima;
  if (last_x <= border_px) return maxima;
  std::vector<Byte> marks(static_cast<std::size_t>(scores.cols));
  for (int y = border_px; y < last_y; ++y) {
    MarkMaxima(scores, y, threshold, border_px, last_x, marks);
    AppendMarked(marks, y, border_px, last_x, maxima);
  }
  return maxima;
}

std::vector<bool> FollowRule(std::span<const Corner> corners, const cv::Size& size,
                             const CornerRule& rule) {
  const int border = rule.border_px;
  const int columns = size.width / rule.cell_px + 1;
  const int rows = size.height / rule.cell_px + 1;
  const auto cell = [&](const Corner& c) {
    return (c.y - border) / rule.cell_px * columns + (c.x - border) / rule.cell_px;
  };
  const auto is_inside = [&](const Corner& c) {
    return c.x >= border && c.y >= border && c.x < size.width - border &&
           c.y < size.height - border;
  };
  std::vector<char> has_strong(static_cast<std::size_t>(columns * rows), 0);
  for (const Corner& c : corners) {
    if (c.score > rule.threshold && is_inside(c)) has_strong[cell(c)] = 1;
  }
  std::vector<bool> follow;
  follow.reserve(corners.size());
  for (const Corner& c : corners) {
    follow.push_back(is_inside(c) && (c.score > rule.threshold || has_strong[cell(c)] == 0));
  }
  return follow;
}

}  // namespace cvo
