// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <opencv2/core/mat.hpp>
#include <optional>
#include <string>
#include <string_view>

namespace cvo {

struct PngHeader {
  int width_px = 0;
  int height_px = 0;
  bool grey = false;  // grey or grey with alpha; else colour or palette
};

// Reads the header of a PNG file with 8 bits per channel from its first bytes alone. Throws Error
// naming `path` for anything else, JPEG included.
PngHeader ReadPngHeader(const std::filesystem::path& path);

// Describes what is wrong with the bytes of a PNG file: a bad signature, a chunk that is truncated
// or has a wrong CRC, no image data, no end. Empty if the file is complete. Needed because decoders
// may return half an image.
[[nodiscard]] std::optional<std::string> FindPngDamage(std::string_view bytes);

struct PngPixels {
  cv::Size size;
  std::string compressed;  // zlib data of the rows, from all IDAT chunks
};

// Returns the pixels of a PNG file of 8-bit grey without interlacing or transparency; empty for any
// other kind. Checksums are verified by FindPngDamage, not here.
std::optional<PngPixels> FindGreyPixels(std::string_view bytes);

// Returns the indices of a PNG file with an 8-bit palette, or the values of a grey one, as
// CV_16UC1. Throws Error if the file is damaged or of another size or kind.
cv::Mat ReadPaletteIndexes(const std::filesystem::path& path, cv::Size size);

}  // namespace cvo
