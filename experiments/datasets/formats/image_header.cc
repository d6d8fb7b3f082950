// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/datasets/formats/image_header.h"

#include <fstream>

#include "core/base/error.h"
#include "experiments/datasets/formats/png.h"

namespace cvo {
namespace {

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

bool IsJpeg(const std::filesystem::path& path) {
  const std::string extension = path.extension().string();
  return extension == ".jpg" || extension == ".jpeg" || extension == ".JPG";
}

cv::Size ReadImageSize(const std::filesystem::path& path) {
  if (!IsJpeg(path)) {
    const PngHeader header = ReadPngHeader(path);
    return {header.width_px, header.height_px};
  }
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
