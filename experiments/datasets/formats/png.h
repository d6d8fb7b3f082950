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

// The header of a PNG file with 8 bits per channel, from its first bytes alone. Throws Error naming
// `path` for anything else, JPEG included.
PngHeader ReadPngHeader(const std::filesystem::path& path);

// What is wrong with the bytes of a PNG file: a bad signature, a chunk cut short or with a wrong
// CRC, no image data, no end. Empty where the file is whole. Decoders may return half an image.
[[nodiscard]] std::optional<std::string> FindPngDamage(std::string_view bytes);

struct PngPixels {
  cv::Size size;
  std::string compressed;  // zlib data of the rows, all IDAT chunks
};

// What a PNG file holds if it is of 8 bits of grey, not interlaced and without transparency; empty
// for any other kind. Checksums are FindPngDamage's.
std::optional<PngPixels> FindGreyPixels(std::string_view bytes);

// CV_16UC1: the indexes of a PNG file with a palette of 8 bits, or the values of a grey one. Throws
// Error for one that is damaged or of another size or kind.
cv::Mat ReadPaletteIndexes(const std::filesystem::path& path, cv::Size size);

}  // namespace cvo
