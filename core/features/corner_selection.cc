// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/features/corner_selection.h"

#include <algorithm>
#include <cmath>

namespace cvo {
namespace {

constexpr int kNone = -1;
constexpr double kExcess = 1.05;  // that many times the quota is near enough; the weakest are cut
constexpr int kMaxBisections = 12;

bool ComesFirst(const Corner& a, const Corner& b) { return a.y != b.y ? a.y < b.y : a.x < b.x; }

bool IsStronger(const Corner& a, const Corner& b) {
  return a.score != b.score ? a.score > b.score : ComesFirst(a, b);
}

// Corners at least `distance` apart, strongest first, on a grid of cells of that side.
class Spreader {
 public:
  explicit Spreader(const std::vector<Corner>& strongest_first) : corners_(strongest_first) {
    for (const Corner& corner : corners_) {
      width_ = std::max(width_, corner.x + 1);
      height_ = std::max(height_, corner.y + 1);
    }
  }

  double LargestDistance() const { return std::hypot(width_, height_); }

  // Stops at `limit` corners.
  const std::vector<Corner>& Spread(double distance, int limit) {
    chosen_.clear();
    next_.clear();
    columns_ = static_cast<int>(width_ / distance) + 1;
    rows_ = static_cast<int>(height_ / distance) + 1;
    first_.assign(static_cast<std::size_t>(columns_) * rows_, kNone);
    for (const Corner& corner : corners_) {
      if (static_cast<int>(chosen_.size()) >= limit) break;
      const int column = static_cast<int>(corner.x / distance);
      const int row = static_cast<int>(corner.y / distance);
      if (IsNearAny(corner, column, row, distance * distance)) continue;
      int& first = first_[static_cast<std::size_t>(row) * columns_ + column];
      next_.push_back(first);
      first = static_cast<int>(chosen_.size());
      chosen_.push_back(corner);
    }
    return chosen_;
  }

 private:
  bool IsNearAny(const Corner& corner, int column, int row, double square) const {
    for (int y = std::max(0, row - 1); y <= std::min(rows_ - 1, row + 1); ++y) {
      for (int x = std::max(0, column - 1); x <= std::min(columns_ - 1, column + 1); ++x) {
        for (int i = first_[static_cast<std::size_t>(y) * columns_ + x]; i != kNone; i = next_[i]) {
          const int dx = chosen_[i].x - corner.x;
          const int dy = chosen_[i].y - corner.y;
          if (dx * dx + dy * dy < square) return true;
        }
      }
    }
    return false;
  }

  const std::vector<Corner>& corners_;
  int width_ = 0;
  int height_ = 0;
  int columns_ = 0;
  int rows_ = 0;
  std::vector<Corner> chosen_;
  std::vector<int> first_;  // chosen corner of a cell
  std::vector<int> next_;   // chosen corner of the same cell
};

}  // namespace

std::vector<Corner> SelectEvenly(std::vector<Corner> corners, int quota) {
  if (quota <= 0) return {};
  if (static_cast<int>(corners.size()) <= quota) return corners;
  std::sort(corners.begin(), corners.end(), IsStronger);
  Spreader spreader(corners);
  const int enough = static_cast<int>(quota * kExcess) + 1;
  double low = 1.0;  // leaves all of them, as no two share a pixel
  double high = spreader.LargestDistance();
  std::vector<Corner> selected = corners;
  for (int i = 0; i < kMaxBisections; ++i) {
    // Counts fall with the square of the distance, so bisect geometrically.
    const double distance = std::sqrt(low * high);
    const std::vector<Corner>& spread = spreader.Spread(distance, enough);
    const int count = static_cast<int>(spread.size());
    if (count < quota) {
      high = distance;
      continue;
    }
    low = distance;
    selected = spread;
    if (count < enough) break;
  }
  selected.resize(static_cast<std::size_t>(quota));
  std::sort(selected.begin(), selected.end(), ComesFirst);
  return selected;
}

}  // namespace cvo
