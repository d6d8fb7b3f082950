// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/association/clip_box.h"

#include <algorithm>

namespace cvo {

std::optional<ImageBox> ClipToImage(const ImageBox& box, const StereoCamera& camera) {
  const double right_px = camera.width_px - 1;
  const double bottom_px = camera.height_px - 1;
  if (box.right_px < 0.0 || box.bottom_px < 0.0 || box.left_px > right_px ||
      box.top_px > bottom_px) {
    return std::nullopt;
  }
  return ImageBox{std::max(box.left_px, 0.0), std::max(box.top_px, 0.0),
                  std::min(box.right_px, right_px), std::min(box.bottom_px, bottom_px)};
}

}  // namespace cvo
