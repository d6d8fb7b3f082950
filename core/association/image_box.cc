// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/association/image_box.h"

#include <algorithm>

namespace cvo {

ImageBox ImageBox::Shrunk(double fraction) const {
  const double dx = fraction * Width();
  const double dy = fraction * Height();
  return {left_px + dx, top_px + dy, right_px - dx, bottom_px - dy};
}

namespace {

double Area(const ImageBox& box) { return box.Width() * box.Height(); }

double CommonArea(const ImageBox& a, const ImageBox& b) {
  const double width = std::min(a.right_px, b.right_px) - std::max(a.left_px, b.left_px);
  const double height = std::min(a.bottom_px, b.bottom_px) - std::max(a.top_px, b.top_px);
  return width <= 0.0 || height <= 0.0 ? 0.0 : width * height;
}

}  // namespace

double IntersectionOverUnion(const ImageBox& a, const ImageBox& b) {
  const double common = CommonArea(a, b);
  return common > 0.0 ? common / (Area(a) + Area(b) - common) : 0.0;
}

double ShareInside(const ImageBox& part, const ImageBox& whole) {
  const double common = CommonArea(part, whole);
  return common > 0.0 ? common / Area(part) : 0.0;
}

}  // namespace cvo
