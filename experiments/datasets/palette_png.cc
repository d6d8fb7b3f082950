// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <map>
#include <opencv2/imgcodecs.hpp>
#include <tuple>

#include "core/base/error.h"
#include "core/files/text_file.h"
#include "experiments/datasets/png.h"

namespace cvo {
namespace {

using Colour = std::tuple<int, int, int>;  // blue, green, red

// Decoders give colours: what stands for them in the palette. The file is known to be whole.
std::map<Colour, int> IndexOfColour(const std::filesystem::path& path, std::string_view bytes) {
  const std::size_t at = bytes.find("PLTE");
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(bytes[i]); };
  std::map<Colour, int> index_of;
  const std::size_t length =
      at == std::string_view::npos ? 0 : static_cast<std::size_t>(byte(at - 2) << 8 | byte(at - 1));
  for (std::size_t i = 0; i < length / 3; ++i) {
    const std::size_t rgb = at + 4 + 3 * i;
    const Colour colour = {byte(rgb + 2), byte(rgb + 1), byte(rgb)};
    if (!index_of.emplace(colour, static_cast<int>(i)).second) {
      ThrowError(path.string(), StrCat("the colour of index ", i, " a second time"),
                 "a palette of different colours");
    }
  }
  return index_of;
}

}  // namespace

cv::Mat ReadPaletteIndexes(const std::filesystem::path& path, cv::Size size) {
  constexpr std::size_t kColourType = 25;
  constexpr int kPalette = 3;
  const std::string bytes = ReadFileBytes(path);
  if (const auto damage = FindPngDamage(bytes)) {
    ThrowError(path.string(), *damage, "a whole PNG image");
  }
  const int type = static_cast<unsigned char>(bytes[kColourType]);
  const cv::Mat buffer(1, static_cast<int>(bytes.size()), CV_8UC1, const_cast<char*>(bytes.data()));
  const cv::Mat image =
      cv::imdecode(buffer, type == kPalette ? cv::IMREAD_COLOR : cv::IMREAD_UNCHANGED);
  const int expected = type == kPalette ? CV_8UC3 : CV_8UC1;
  if (image.type() != expected || image.size() != size) {
    ThrowError(path.string(),
               StrCat("a mask of ", image.cols, "x", image.rows, " pixels and ", image.channels(),
                      " channels"),
               StrCat("an indexed one of ", size.width, "x", size.height));
  }
  cv::Mat indexes;
  if (type != kPalette) {
    image.convertTo(indexes, CV_16UC1);
    return indexes;
  }
  const std::map<Colour, int> index_of = IndexOfColour(path, bytes);
  indexes.create(size, CV_16UC1);
  for (int v = 0; v < size.height; ++v) {
    for (int u = 0; u < size.width; ++u) {
      const auto& c = image.at<cv::Vec3b>(v, u);
      indexes.at<std::uint16_t>(v, u) = static_cast<std::uint16_t>(index_of.at({c[0], c[1], c[2]}));
    }
  }
  return indexes;
}

}  // namespace cvo
