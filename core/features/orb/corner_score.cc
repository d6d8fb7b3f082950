// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/features/orb/corner_score.h"

#include <algorithm>
#include <bit>
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

// Written so that the compiler vectorises them as byte-wise minima and maxima.
constexpr auto kMin = [](Byte a, Byte b) { return a < b ? a : b; };
constexpr auto kMax = [](Byte a, Byte b) { return a > b ? a : b; };

// Returns the best, over the 16 arcs of 9 pixels, of the worst value of an arc. Arcs are evaluated
// in pairs that share 8 pixels.
[[gnu::always_inline]] inline Byte BestArc(const Byte (&value)[kRing], auto best, auto worst) {
  Byte pairs[8];
  Byte fours[8];
  Byte arcs[8];
  for (int i = 0; i < 8; ++i) pairs[i] = worst(value[2 * i + 1], value[(2 * i + 2) % kRing]);
  for (int i = 0; i < 8; ++i) fours[i] = worst(pairs[i], pairs[(i + 1) % 8]);
  for (int i = 0; i < 8; ++i) {
    const Byte eight = worst(fours[i], fours[(i + 2) % 8]);
    arcs[i] = worst(eight, best(value[2 * i], value[(2 * i + 9) % kRing]));
  }
  for (int i = 1; i < 8; ++i) arcs[0] = best(arcs[0], arcs[i]);
  return arcs[0];
}

CVO_FOR_EACH_PROCESSOR
void ScoreRow(const Byte* row, const std::ptrdiff_t (&ring)[kRing], int count,
              Byte* __restrict scores) {
  for (int x = 0; x < count; ++x) {
    Byte value[kRing];
    for (int k = 0; k < kRing; ++k) value[k] = row[x + ring[k]];
    const Byte centre = row[x];
    const Byte brightest = kMax(BestArc(value, kMax, kMin), centre);
    const Byte darkest = kMin(BestArc(value, kMin, kMax), centre);
    scores[x] = kMax(static_cast<Byte>(brightest - centre), static_cast<Byte>(centre - darkest));
  }
}

// Sets marks[x] to the score at x if it is a maximum above the threshold, else to 0.
CVO_FOR_EACH_PROCESSOR
void MarkMaxima(const Byte* above, const Byte* row, const Byte* below, Byte least, int first,
                int last, Byte* __restrict marks) {
  for (int x = first; x < last; ++x) {
    const Byte before = kMax(kMax(above[x - 1], above[x]), kMax(above[x + 1], row[x - 1]));
    const Byte after = kMax(kMax(row[x + 1], below[x - 1]), kMax(below[x], below[x + 1]));
    const Byte score = row[x];
    const bool is_corner = (score > kMax(before, least)) & (score >= after);
    marks[x] = is_corner ? score : Byte{0};
  }
}

// Visits eight marks at a time; seven zeros must follow the last.
void AppendMarked(const Byte* marks, int y, int first, int last, std::vector<Corner>& corners) {
  static_assert(std::endian::native == std::endian::little, "the first mark is the lowest byte");
  for (int x = first; x < last; x += 8) {
    std::uint64_t eight = 0;
    std::memcpy(&eight, marks + x, 8);
    while (eight != 0) {
      const int bit = std::countr_zero(eight) & ~7;
      corners.push_back({x + bit / 8, y, static_cast<Byte>(eight >> bit)});
      eight &= ~(std::uint64_t{0xFF} << bit);
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
  std::vector<Byte> marks(static_cast<std::size_t>(scores.cols) + 7);
  for (int y = border_px; y < last_y; ++y) {
    MarkMaxima(scores.ptr<Byte>(y - 1), scores.ptr<Byte>(y), scores.ptr<Byte>(y + 1),
               static_cast<Byte>(threshold), border_px, last_x, marks.data());
    AppendMarked(marks.data(), y, border_px, last_x, maxima);
  }
  return maxima;
}

std::vector<char> FollowRule(std::span<const Corner> corners, const cv::Size& size,
                             const CornerRule& rule) {
  constexpr int kOutside = -1;
  const int border = rule.border_px;
  const int columns = size.width / rule.cell_px + 1;
  const int rows = size.height / rule.cell_px + 1;
  const auto cell = [&](const Corner& c) {
    const bool is_inside =
        c.x >= border && c.y >= border && c.x < size.width - border && c.y < size.height - border;
    if (!is_inside) return kOutside;
    return (c.y - border) / rule.cell_px * columns + (c.x - border) / rule.cell_px;
  };
  std::vector<char> has_strong(static_cast<std::size_t>(columns * rows), 0);
  std::vector<int> cells;
  cells.reserve(corners.size());
  for (const Corner& c : corners) {
    cells.push_back(cell(c));
    if (c.score > rule.threshold && cells.back() != kOutside) has_strong[cells.back()] = 1;
  }
  std::vector<char> follow(corners.size());
  for (std::size_t i = 0; i < corners.size(); ++i) {
    follow[i] =
        cells[i] != kOutside && (corners[i].score > rule.threshold || has_strong[cells[i]] == 0);
  }
  return follow;
}

}  // namespace cvo
