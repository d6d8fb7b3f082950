// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/features/orb/corner_selection.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace cvo {
namespace {

constexpr double kExcess = 1.05;  // that many times the quota is near enough; the weakest are cut
constexpr int kMaxTrials = 12;

// Strongest first; equally strong ones stay in their order. Scores are 0 ... 255.
std::vector<Corner> SortByScore(const std::vector<Corner>& corners) {
  std::array<int, 257> begin{};  // of the corners with score 255 - i
  for (const Corner& corner : corners) ++begin[256 - corner.score];
  for (std::size_t i = 1; i < begin.size(); ++i) begin[i] += begin[i - 1];
  std::vector<Corner> sorted(corners.size());
  for (const Corner& corner : corners) sorted[begin[255 - corner.score]++] = corner;
  return sorted;
}

// Corners at least a distance apart, strongest first. Keeps a picture of what the discs around
// those already chosen cover.
class EvenSelector {
 public:
  explicit EvenSelector(const std::vector<Corner>& strongest_first) : corners_(strongest_first) {
    x0_ = x1_ = corners_[0].x;
    y0_ = y1_ = corners_[0].y;
    for (const Corner& corner : corners_) {
      x0_ = std::min(x0_, corner.x);
      x1_ = std::max(x1_, corner.x);
      y0_ = std::min(y0_, corner.y);
      y1_ = std::max(y1_, corner.y);
    }
  }

  int width() const { return x1_ - x0_ + 1; }
  int height() const { return y1_ - y0_ + 1; }

  // Stops at `limit` corners.
  std::vector<Corner> Spread(double distance, int limit) {
    covered_.assign(static_cast<std::size_t>(width()) * height(), 0);
    std::vector<int> half_widths;  // of the disc's rows, by |y|
    for (int y = 0; y < distance; ++y) {
      const int half = static_cast<int>(std::ceil(std::sqrt(distance * distance - y * y))) - 1;
      half_widths.push_back(half);
    }
    std::vector<Corner> chosen;
    for (const Corner& corner : corners_) {
      if (static_cast<int>(chosen.size()) >= limit) break;
      const std::size_t row = static_cast<std::size_t>(corner.y - y0_);
      if (covered_[row * width() + (corner.x - x0_)] != 0) continue;
      chosen.push_back(corner);
      Cover(corner, half_widths);
    }
    return chosen;
  }

 private:
  void Cover(const Corner& corner, const std::vector<int>& half_widths) {
    const int reach = static_cast<int>(half_widths.size()) - 1;
    for (int y = std::max(y0_, corner.y - reach); y <= std::min(y1_, corner.y + reach); ++y) {
      const int half = half_widths[std::abs(y - corner.y)];
      const int left = std::max(x0_, corner.x - half);
      const int right = std::min(x1_, corner.x + half);
      std::memset(&covered_[static_cast<std::size_t>(y - y0_) * width() + (left - x0_)], 1,
                  static_cast<std::size_t>(right - left + 1));
    }
  }

  const std::vector<Corner>& corners_;
  int x0_, x1_, y0_, y1_;
  std::vector<std::uint8_t> covered_;
};

}  // namespace

std::vector<Corner> SelectEvenly(const std::vector<Corner>& corners, int quota) {
  if (quota <= 0) return {};
  if (static_cast<int>(corners.size()) <= quota) return corners;
  const std::vector<Corner> sorted = SortByScore(corners);
  EvenSelector selector(sorted);
  const int enough = static_cast<int>(quota * kExcess) + 1;
  double low = 1.0;  // leaves all of them, as no two share a pixel
  double high = std::hypot(selector.width(), selector.height());
  double distance = std::sqrt(static_cast<double>(selector.width()) * selector.height() / quota);
  std::vector<Corner> selected = sorted;
  for (int trial = 0; trial < kMaxTrials; ++trial) {
    // Counts fall with the square of the distance.
    if (!(distance > low && distance < high)) distance = std::sqrt(low * high);
    std::vector<Corner> spread = selector.Spread(distance, 2 * quota);
    const int count = static_cast<int>(spread.size());
    (count < quota ? high : low) = distance;
    distance *= std::sqrt(count / (0.5 * (quota + enough)));
    if (count < quota) continue;
    selected = std::move(spread);
    if (count <= enough) break;
  }
  selected.resize(static_cast<std::size_t>(quota));
  std::sort(selected.begin(), selected.end(), InReadingOrder);
  return selected;
}

}  // namespace cvo
