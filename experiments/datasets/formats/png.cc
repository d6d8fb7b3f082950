// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/datasets/formats/png.h"

#include <libdeflate.h>

#include <array>
#include <cstdint>
#include <fstream>
#include <map>
#include <tuple>

#include "core/base/error.h"
#include "core/files/images/image_codec.h"
#include "core/files/images/image_limits.h"
#include "core/files/text_file.h"

namespace cvo {
namespace {

constexpr std::string_view kSignature = "\x89PNG\r\n\x1a\n";
// Signature, then length, "IHDR", width, height, bit depth, colour type, ...
constexpr std::size_t kHeaderBytes = 26;
constexpr std::size_t kChunkOverhead = 12;  // length, type, CRC
constexpr int kColourTypeGrey = 0;
constexpr int kColourTypeGreyAlpha = 4;

std::uint32_t Crc32(std::string_view bytes) {
  return libdeflate_crc32(0, bytes.data(), bytes.size());
}

std::uint32_t ReadBigEndian(std::string_view bytes, std::size_t offset) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    value = value << 8 | static_cast<unsigned char>(bytes[offset + i]);
  }
  return value;
}

std::string DescribeNonPng(std::string_view bytes) {
  if (bytes.empty()) return "an empty file";
  if (bytes.substr(0, 2) == "\xff\xd8") return "a JPEG image";
  if (bytes.size() < kHeaderBytes && kSignature.starts_with(bytes.substr(0, kSignature.size()))) {
    return "a PNG header cut short";
  }
  return "a file that is not PNG";
}

using Colour = std::tuple<int, int, int>;  // blue, green, red

// Decoders return colours; this maps each colour to its index in the palette. The file must be
// complete.
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

PngHeader ReadPngHeader(const std::filesystem::path& path) {
  const char* const expected = "a PNG image with 8 bits per channel";
  const std::string header = ReadFileBytes(path, kHeaderBytes);
  const std::string_view bytes = header;
  if (bytes.size() < kHeaderBytes || !bytes.starts_with(kSignature) ||
      bytes.substr(12, 4) != "IHDR") {
    ThrowError(path.string(), DescribeNonPng(bytes), expected);
  }
  const std::uint32_t width = ReadBigEndian(bytes, 16);
  const std::uint32_t height = ReadBigEndian(bytes, 20);
  if (width == 0 || height == 0 || width > kMaxSide_px || height > kMaxSide_px) {
    ThrowError(path.string(), StrCat(width, "x", height, " pixels"),
               StrCat("sides between 1 and ", kMaxSide_px));
  }
  if (bytes[24] != 8) {
    ThrowError(path.string(), StrCat(static_cast<int>(bytes[24]), " bits per channel"), expected);
  }
  const int colour_type = static_cast<unsigned char>(bytes[25]);
  return {static_cast<int>(width), static_cast<int>(height),
          colour_type == kColourTypeGrey || colour_type == kColourTypeGreyAlpha};
}

std::optional<std::string> FindPngDamage(std::string_view bytes) {
  if (bytes.size() < kHeaderBytes || !bytes.starts_with(kSignature)) return DescribeNonPng(bytes);
  bool has_data = false;
  std::size_t at = kSignature.size();
  while (at + kChunkOverhead <= bytes.size()) {
    const std::size_t length = ReadBigEndian(bytes, at);
    const std::string type(bytes.substr(at + 4, 4));
    if (length > bytes.size() - at - kChunkOverhead) {
      return StrCat("chunk ", type, " at byte ", at, " cut short");
    }
    if (Crc32(bytes.substr(at + 4, length + 4)) != ReadBigEndian(bytes, at + 8 + length)) {
      return StrCat("a wrong CRC in chunk ", type, " at byte ", at);
    }
    if (type == "IDAT") has_data = true;
    if (type == "IEND") {
      return has_data ? std::nullopt : std::optional<std::string>("no image data");
    }
    at += kChunkOverhead + length;
  }
  return StrCat("a file cut short after ", bytes.size(), " bytes, without an end");
}

std::optional<PngPixels> FindGreyPixels(std::string_view bytes) {
  constexpr std::size_t kInterlace = 28;
  if (bytes.size() <= kInterlace || bytes[24] != 8 || bytes[25] != kColourTypeGrey ||
      bytes[kInterlace] != 0) {
    return std::nullopt;
  }
  const std::uint32_t width = ReadBigEndian(bytes, 16);
  const std::uint32_t height = ReadBigEndian(bytes, 20);
  if (width > kMaxSide_px || height > kMaxSide_px) return std::nullopt;
  PngPixels pixels{{static_cast<int>(width), static_cast<int>(height)}, {}};
  std::size_t at = kSignature.size();
  while (at + kChunkOverhead <= bytes.size()) {
    const std::size_t length = ReadBigEndian(bytes, at);
    const std::string_view type = bytes.substr(at + 4, 4);
    if (type == "tRNS" || length > bytes.size() - at - kChunkOverhead) return std::nullopt;
    if (type == "IDAT") pixels.compressed += bytes.substr(at + 8, length);
    at += kChunkOverhead + length;
  }
  return pixels;
}

cv::Mat ReadPaletteIndexes(const std::filesystem::path& path, cv::Size size) {
  constexpr std::size_t kColourType = 25;
  constexpr int kPalette = 3;
  const std::string bytes = ReadFileBytes(path);
  if (const auto damage = FindPngDamage(bytes)) {
    ThrowError(path.string(), *damage, "a whole PNG image");
  }
  const int type = static_cast<unsigned char>(bytes[kColourType]);
  const cv::Mat image =
      DecodeImage(bytes, type == kPalette ? cv::IMREAD_COLOR : cv::IMREAD_UNCHANGED);
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
