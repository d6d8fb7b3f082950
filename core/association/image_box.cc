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

double IntersectionOverUnion(const ImageBox& a, const ImageBox& b) {
  const double width = std::min(a.right_px, b.right_px) - std::max(a.left_px, b.left_px);
  const double height = std::min(a.bottom_px, b.bottom_px) - std::max(a.top_px, b.top_px);
  if (width <= 0.0 || height <= 0.0) return 0.0;
  const double common = width * height;
  return common / (a.Width() * a.Height() + b.Width() * b.Height() - common);
}

}  // namespace cvo
