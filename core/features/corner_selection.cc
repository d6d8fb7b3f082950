// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/features/corner_selection.h"

#include <algorithm>
#include <cmath>

namespace cvo {
namespace {

// The corners [begin, end) lie in [x0, x1) x [y0, y1).
struct Leaf {
  int x0, y0, x1, y1;
  int begin, end;

  int Count() const { return end - begin; }
};

bool ComesFirst(const Corner& a, const Corner& b) { return a.y != b.y ? a.y < b.y : a.x < b.x; }

bool IsStronger(const Corner& a, const Corner& b) {
  return a.score != b.score ? a.score > b.score : ComesFirst(a, b);
}

// Replaces a leaf by its occupied quarters, which are appended to `quarters`.
void Split(const Leaf& leaf, std::vector<Corner>& corners, std::vector<Leaf>& quarters) {
  const int x = (leaf.x0 + leaf.x1) / 2;
  const int y = (leaf.y0 + leaf.y1) / 2;
  const auto begin = corners.begin() + leaf.begin;
  const auto end = corners.begin() + leaf.end;
  const auto is_left = [x](const Corner& corner) { return corner.x < x; };
  const auto middle = std::partition(begin, end, [y](const Corner& c) { return c.y < y; });
  const auto top_middle = std::partition(begin, middle, is_left);
  const auto bottom_middle = std::partition(middle, end, is_left);
  const auto append = [&](int x0, int y0, int x1, int y1, auto from, auto to) {
    if (from == to) return;
    quarters.push_back({x0, y0, x1, y1, static_cast<int>(from - corners.begin()),
                        static_cast<int>(to - corners.begin())});
  };
  append(leaf.x0, leaf.y0, x, y, begin, top_middle);
  append(x, leaf.y0, leaf.x1, y, top_middle, middle);
  append(leaf.x0, y, x, leaf.y1, middle, bottom_middle);
  append(x, y, leaf.x1, leaf.y1, bottom_middle, end);
}

// Near-square leaves over the corners' bounding box.
std::vector<Leaf> Roots(std::vector<Corner>& corners) {
  int x0 = corners[0].x, x1 = x0 + 1, y0 = corners[0].y, y1 = y0 + 1;
  for (const Corner& corner : corners) {
    x0 = std::min(x0, corner.x);
    x1 = std::max(x1, corner.x + 1);
    y0 = std::min(y0, corner.y);
    y1 = std::max(y1, corner.y + 1);
  }
  const int columns = std::max(1, (x1 - x0 + (y1 - y0) / 2) / (y1 - y0));
  std::vector<Leaf> roots;
  int begin = 0;
  for (int i = 0; i < columns; ++i) {
    const int left = x0 + (x1 - x0) * i / columns;
    const int right = x0 + (x1 - x0) * (i + 1) / columns;
    const auto end = std::partition(corners.begin() + begin, corners.end(),
                                    [right](const Corner& corner) { return corner.x < right; });
    const int end_index = static_cast<int>(end - corners.begin());
    if (end_index > begin) roots.push_back({left, y0, right, y1, begin, end_index});
    begin = end_index;
  }
  return roots;
}

// Splits until there are `quota` leaves or every leaf has one corner.
std::vector<Leaf> Divide(std::vector<Corner>& corners, int quota) {
  std::vector<Leaf> leaves = Roots(corners);
  while (static_cast<int>(leaves.size()) < quota) {
    // One generation; the fullest first, for the one that reaches the quota.
    std::stable_sort(leaves.begin(), leaves.end(),
                     [](const Leaf& a, const Leaf& b) { return a.Count() > b.Count(); });
    std::vector<Leaf> next;
    std::size_t i = 0;
    for (; i < leaves.size() && leaves[i].Count() > 1; ++i) {
      if (static_cast<int>(next.size() + leaves.size() - i) >= quota) break;
      Split(leaves[i], corners, next);
    }
    if (i == 0) break;
    next.insert(next.end(), leaves.begin() + static_cast<std::ptrdiff_t>(i), leaves.end());
    leaves = std::move(next);
  }
  return leaves;
}

}  // namespace

std::vector<Corner> SelectEvenly(std::vector<Corner> corners, int quota) {
  if (quota <= 0) return {};
  if (static_cast<int>(corners.size()) <= quota) return corners;
  std::vector<Corner> selected;
  for (const Leaf& leaf : Divide(corners, quota)) {
    selected.push_back(
        *std::min_element(corners.begin() + leaf.begin, corners.begin() + leaf.end, IsStronger));
  }
  if (static_cast<int>(selected.size()) > quota) {
    std::sort(selected.begin(), selected.end(), IsStronger);
    selected.resize(static_cast<std::size_t>(quota));
  }
  std::sort(selected.begin(), selected.end(), ComesFirst);
  return selected;
}

}  // namespace cvo
