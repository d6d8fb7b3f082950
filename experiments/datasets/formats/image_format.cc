// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/datasets/formats/image_format.h"

#include <libdeflate.h>

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/files/text_file.h"

namespace cvo {
namespace {

constexpr std::string_view kSignature = "\x89PNG\r\n\x1a\n";
// Signature, then length, "IHDR", width, height, bit depth, colour type, ...
constexpr std::size_t kHeaderBytes = 26;
constexpr std::uint32_t kMaxSide_px = 1 << 15;
constexpr std::size_t kChunkOverhead = 12;  // length, type, CRC

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

// From the first bytes alone.
cv::Size ReadPngSize(const std::filesystem::path& path) {
  const char* const expected = "a PNG image with 8 or 16 bits per channel";
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
  if (bytes[24] != 8 && bytes[24] != 16) {
    ThrowError(path.string(), StrCat(static_cast<int>(bytes[24]), " bits per channel"), expected);
  }
  return {static_cast<int>(width), static_cast<int>(height)};
}

struct Chunk {
  std::string_view type, data;
};

// Returns the chunk at this byte; empty if the file ends before the chunk does.
std::optional<Chunk> ChunkAt(std::string_view bytes, std::size_t at) {
  if (at + kChunkOverhead > bytes.size()) return std::nullopt;
  const std::size_t length = ReadBigEndian(bytes, at);
  if (length > bytes.size() - at - kChunkOverhead) return std::nullopt;
  return Chunk{bytes.substr(at + 4, 4), bytes.substr(at + 8, length)};
}

struct PngPixels {
  cv::Size size;
  std::string compressed;  // zlib data of the rows, from all IDAT chunks
};

// Returns the pixels of a PNG file of 8-bit grey without transparency or interlacing; empty for any
// other kind.
std::optional<PngPixels> FindPixels(std::string_view bytes) {
  constexpr std::size_t kInterlace = 28;
  if (bytes.size() <= kInterlace || bytes[24] != 8 || bytes[25] != 0 || bytes[kInterlace] != 0) {
    return std::nullopt;
  }
  const std::uint32_t width = ReadBigEndian(bytes, 16);
  const std::uint32_t height = ReadBigEndian(bytes, 20);
  if (width > kMaxSide_px || height > kMaxSide_px) return std::nullopt;
  PngPixels pixels{{static_cast<int>(width), static_cast<int>(height)}, {}};
  std::size_t at = kSignature.size();
  while (const auto chunk = ChunkAt(bytes, at)) {
    if (chunk->type == "tRNS") return std::nullopt;
    if (chunk->type == "IDAT") pixels.compressed += chunk->data;
    at += kChunkOverhead + chunk->data.size();
  }
  return pixels;
}

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
  constexpr std::size_t kMaxRatio = 1032;  // of deflate
  if (size / kMaxRatio > compressed.size()) return std::nullopt;
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

constexpr std::string_view kStart = "\xff\xd8";
constexpr std::string_view kEnd = "\xff\xd9";

int ReadTwoBytes(std::istream& in) {
  const int high = in.get();
  return high << 8 | in.get();
}

// A segment consists of a marker, its length and its bytes. The segment of a frame header contains
// the size.
std::optional<cv::Size> FindJpegSize(std::istream& in) {
  if (ReadTwoBytes(in) != 0xffd8) return std::nullopt;
  while (in) {
    const int marker = ReadTwoBytes(in);
    const int length = ReadTwoBytes(in);
    if ((marker & 0xff00) != 0xff00 || length < 2) return std::nullopt;
    const int kind = marker & 0xff;
    const bool frame = kind >= 0xc0 && kind <= 0xcf && kind != 0xc4 && kind != 0xc8 && kind != 0xcc;
    if (!frame) {
      in.ignore(length - 2);
      continue;
    }
    in.ignore(1);  // bits per sample
    const int height_px = ReadTwoBytes(in);
    const int width_px = ReadTwoBytes(in);
    if (!in || height_px <= 0 || width_px <= 0) return std::nullopt;
    return cv::Size(width_px, height_px);
  }
  return std::nullopt;
}

}  // namespace

std::optional<std::string> FindPngDamage(std::string_view bytes) {
  if (bytes.size() < kHeaderBytes || !bytes.starts_with(kSignature)) return DescribeNonPng(bytes);
  bool has_data = false;
  std::size_t at = kSignature.size();
  while (const auto chunk = ChunkAt(bytes, at)) {
    const std::size_t length = chunk->data.size();
    if (Crc32(bytes.substr(at + 4, length + 4)) != ReadBigEndian(bytes, at + 8 + length)) {
      return StrCat("a wrong CRC in chunk ", chunk->type, " at byte ", at);
    }
    if (chunk->type == "IDAT") has_data = true;
    if (chunk->type == "IEND") {
      return has_data ? std::nullopt : std::optional<std::string>("no image data");
    }
    at += kChunkOverhead + length;
  }
  return StrCat("a file cut short after ", bytes.size(), " bytes, without an end");
}

cv::Mat DecodeGreyPng(std::string_view bytes) {
  const std::optional<PngPixels> pixels = FindPixels(bytes);
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

std::string LowerExtension(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

bool IsJpeg(const std::filesystem::path& path) {
  const std::string extension = LowerExtension(path);
  return extension == ".jpg" || extension == ".jpeg";
}

cv::Size ReadImageSize(const std::filesystem::path& path) {
  if (!IsJpeg(path)) return ReadPngSize(path);
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored)) {
    ThrowError(path.string(), "no file, or a pipe or a device", "a JPEG image");
  }
  std::ifstream in(path, std::ios::binary);
  const std::optional<cv::Size> size = FindJpegSize(in);
  if (!size) ThrowError(path.string(), "a file without the header of a JPEG image", "one");
  return *size;
}

std::optional<std::string> FindJpegDamage(std::string_view bytes) {
  if (!bytes.starts_with(kStart)) return "a file that is not JPEG";
  if (!bytes.ends_with(kEnd)) {
    return StrCat("a file cut short after ", bytes.size(), " bytes, without an end");
  }
  return std::nullopt;
}

}  // namespace cvo
