// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/files/images/float_tiff.h"

#include <tiffio.h>

#include <cstdint>
#include <memory>
#include <sstream>
#include <string>
#include <tiffio.hxx>

#include "core/files/images/image_limits.h"

namespace cvo {
namespace {

// libtiff prints its messages unless told otherwise.
void Silence() {
  static const auto silent = [] {
    TIFFSetWarningHandler(nullptr);
    return TIFFSetErrorHandler(nullptr);
  }();
  static_cast<void>(silent);
}

template <typename Value>
Value Field(TIFF* tiff, std::uint32_t tag) {
  Value value = 0;
  TIFFGetFieldDefaulted(tiff, tag, &value);
  return value;
}

bool IsFloatImage(TIFF* tiff) {
  const auto field = [&](std::uint32_t tag) { return Field<std::uint16_t>(tiff, tag); };
  const int compression = field(TIFFTAG_COMPRESSION);
  return TIFFIsTiled(tiff) == 0 && field(TIFFTAG_BITSPERSAMPLE) == 32 &&
         field(TIFFTAG_SAMPLESPERPIXEL) == 1 &&
         field(TIFFTAG_SAMPLEFORMAT) == SAMPLEFORMAT_IEEEFP &&
         field(TIFFTAG_PHOTOMETRIC) == PHOTOMETRIC_MINISBLACK &&
         field(TIFFTAG_ORIENTATION) == ORIENTATION_TOPLEFT &&
         (compression == COMPRESSION_NONE || compression == COMPRESSION_ADOBE_DEFLATE);
}

}  // namespace

std::optional<FloatImage> DecodeFloatTiff(std::string_view bytes) {
  Silence();
  std::istringstream stream{std::string(bytes)};
  const std::unique_ptr<TIFF, void (*)(TIFF*)> file(TIFFStreamOpen("depth", &stream), TIFFClose);
  if (file == nullptr || !IsFloatImage(file.get())) return std::nullopt;
  const auto width = Field<std::uint32_t>(file.get(), TIFFTAG_IMAGEWIDTH);
  const auto height = Field<std::uint32_t>(file.get(), TIFFTAG_IMAGELENGTH);
  if (width == 0 || height == 0 || width > kMaxSide_px || height > kMaxSide_px) return std::nullopt;
  const std::size_t size = sizeof(float) * width * height;
  if (!CanHold(bytes.size(), size)) return std::nullopt;

  FloatImage image{static_cast<int>(width), static_cast<int>(height), {}};
  image.values.resize(size / sizeof(float));
  std::size_t done = 0;
  for (std::uint32_t strip = 0; strip < TIFFNumberOfStrips(file.get()); ++strip) {
    const tmsize_t read =
        TIFFReadEncodedStrip(file.get(), strip, reinterpret_cast<char*>(image.values.data()) + done,
                             static_cast<tmsize_t>(size - done));
    if (read < 0) return std::nullopt;
    done += static_cast<std::size_t>(read);
  }
  if (done != size) return std::nullopt;
  return image;
}

}  // namespace cvo
