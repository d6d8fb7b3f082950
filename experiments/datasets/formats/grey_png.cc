// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/datasets/formats/grey_png.h"

#include <libdeflate.h>

#include <cstdint>
#include <cstdlib>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/files/images/image_limits.h"
#include "experiments/datasets/formats/png.h"

namespace cvo {
namespace {

using Row = std::span<std::uint8_t>;
using ConstRow = std::span<const std::uint8_t>;

// Filters of a row (PNG specification, W3C, section 9), which predict a pixel from the one to the
// left, the one above, or both.
enum Filter : std::uint8_t { kNone, kSub, kUp, kAverage, kPaeth };

// Returns the one of left, above and above-left that is nearest to left + above - above-left.
int Paeth(int left, int above, int above_left) {
  const int to_left = std::abs(above - above_left);
  const int to_above = std::abs(left - above_left);
  const int to_above_left = std::abs(left + above - 2 * above_left);
  if (to_left <= to_above && to_left <= to_above_left) return left;
  return to_above <= to_above_left ? above : above_left;
}

// Adds predict(left, above, above_left) to each filtered pixel of the row in turn.
void AddPredicted(ConstRow filtered, ConstRow above, Row row, auto&& predict) {
  int left = 0;
  int above_left = 0;
  for (std::size_t x = 0; x < row.size(); ++x) {
    row[x] = static_cast<std::uint8_t>(filtered[x] + predict(left, above[x], above_left));
    left = row[x];
    above_left = above[x];
  }
}

bool Unfilter(int filter, ConstRow filtered, ConstRow above, Row row) {
  switch (filter) {
    case kNone:
      AddPredicted(filtered, above, row, [](int, int, int) { return 0; });
      return true;
    case kSub:
      AddPredicted(filtered, above, row, [](int left, int, int) { return left; });
      return true;
    case kUp:
      AddPredicted(filtered, above, row, [](int, int up, int) { return up; });
      return true;
    case kAverage:
      AddPredicted(filtered, above, row, [](int left, int up, int) { return (left + up) / 2; });
      return true;
    case kPaeth:
      AddPredicted(filtered, above, row, Paeth);
      return true;
    default:
      return false;
  }
}

// Returns the rows of an image, each preceded by the byte that selects its filter. Refuses a size
// that so few bytes cannot hold before allocating memory for it.
std::optional<std::vector<std::uint8_t>> Inflate(const std::string& compressed, std::size_t size) {
  if (!CanHold(compressed.size(), size)) return std::nullopt;
  const std::unique_ptr<libdeflate_decompressor, decltype(&libdeflate_free_decompressor)>
      decompressor(libdeflate_alloc_decompressor(), libdeflate_free_decompressor);
  std::vector<std::uint8_t> bytes(size);
  if (!decompressor ||
      libdeflate_zlib_decompress(decompressor.get(), compressed.data(), compressed.size(),
                                 bytes.data(), size, nullptr) != LIBDEFLATE_SUCCESS) {
    return std::nullopt;
  }
  return bytes;
}

}  // namespace

cv::Mat DecodeGreyPng(std::string_view bytes) {
  const std::optional<PngPixels> pixels = FindGreyPixels(bytes);
  if (!pixels) return {};
  const auto width = static_cast<std::size_t>(pixels->size.width);
  const auto height = static_cast<std::size_t>(pixels->size.height);
  const auto inflated = Inflate(pixels->compressed, (width + 1) * height);
  if (!inflated) return {};
  cv::Mat image(pixels->size, CV_8UC1);
  const std::vector<std::uint8_t> nothing(width);
  ConstRow above = nothing;
  ConstRow rows = *inflated;
  for (int y = 0; y < image.rows; ++y, rows = rows.subspan(width + 1)) {
    const Row row(image.ptr<std::uint8_t>(y), width);
    if (!Unfilter(rows[0], rows.subspan(1, width), above, row)) return {};
    above = row;
  }
  return image;
}

}  // namespace cvo
