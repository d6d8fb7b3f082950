// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/metrics/kitti_ap/box_class.h"

#include <algorithm>
#include <cctype>

namespace cvo {
namespace {

bool SameText(const std::string& a, const std::string& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](unsigned char x, unsigned char y) {
    return std::tolower(x) == std::tolower(y);
  });
}

}  // namespace

bool IsOfClass(const ObjectBox& box, const std::string& category) {
  return SameText(box.type, category);
}

bool IsNeighbour(const ObjectBox& box, const std::string& category) {
  if (SameText(category, "car")) return SameText(box.type, "van");
  return SameText(category, "pedestrian") &&
         (SameText(box.type, "person_sitting") || SameText(box.type, "person"));
}

bool IsDontCare(const ObjectBox& label) { return SameText(label.type, "dontcare"); }

}  // namespace cvo
