// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace cvo {

struct FloatImage {
  int width_px = 0;
  int height_px = 0;
  std::vector<float> values;  // row by row
};

// Decodes a TIFF file of one 32-bit float per pixel, in strips without compression or compressed
// by deflate. Empty for any other kind of file and for damaged ones. Has its own files because
// libtiff's declarations clash with OpenCV's types.
[[nodiscard]] std::optional<FloatImage> DecodeFloatTiff(std::string_view bytes);

}  // namespace cvo
