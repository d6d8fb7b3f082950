// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/datasets/png.h"

#include <array>
#include <cstdint>
#include <fstream>

#include "core/base/error.h"

namespace cvo {
namespace {

constexpr std::string_view kSignature = "\x89PNG\r\n\x1a\n";
// Signature, then length, "IHDR", width, height, bit depth, colour type, ...
constexpr std::size_t kHeaderBytes = 26;
constexpr int kColourTypeGrey = 0;
constexpr int kColourTypeGreyAlpha = 4;

// table[k][n]: the CRC of byte n followed by k zero bytes, to take eight bytes at a time.
using CrcTables = std::array<std::array<std::uint32_t, 256>, 8>;

constexpr CrcTables MakeCrcTables() {
  CrcTables table{};
  for (std::uint32_t n = 0; n < 256; ++n) {
    std::uint32_t c = n;
    for (int k = 0; k < 8; ++k) c = (c & 1) ? 0xEDB88320u ^ (c >> 1) : c >> 1;
    table[0][n] = c;
  }
  for (std::size_t k = 1; k < table.size(); ++k) {
    for (std::size_t n = 0; n < 256; ++n) {
      const std::uint32_t c = table[k - 1][n];
      table[k][n] = table[0][c & 0xFF] ^ (c >> 8);
    }
  }
  return table;
}
constexpr CrcTables kCrc = MakeCrcTables();

std::uint32_t Crc32(std::string_view bytes) {
  std::uint32_t c = 0xFFFFFFFFu;
  const auto byte = [&](std::size_t i) {
    return static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[i]));
  };
  std::size_t i = 0;
  for (; i + 8 <= bytes.size(); i += 8) {
    c ^= byte(i) | byte(i + 1) << 8 | byte(i + 2) << 16 | byte(i + 3) << 24;
    c = kCrc[7][c & 0xFF] ^ kCrc[6][c >> 8 & 0xFF] ^ kCrc[5][c >> 16 & 0xFF] ^ kCrc[4][c >> 24] ^
        kCrc[3][byte(i + 4)] ^ kCrc[2][byte(i + 5)] ^ kCrc[1][byte(i + 6)] ^ kCrc[0][byte(i + 7)];
  }
  for (; i < bytes.size(); ++i) c = kCrc[0][(c ^ byte(i)) & 0xFF] ^ (c >> 8);
  return c ^ 0xFFFFFFFFu;
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
  constexpr std::uint32_t kMaxSide_px = 1 << 15;
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
  constexpr std::size_t kChunkOverhead = 12;  // length, type, CRC
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

}  // namespace cvo
