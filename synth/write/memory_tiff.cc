// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "synth/write/memory_tiff.h"

#include <tiffio.h>

#include <algorithm>
#include <cstring>
#include <memory>
#include <vector>

#include "core/base/error.h"

namespace cvo::synth {
namespace {

// A file in memory for libtiff.
struct MemoryFile {
  std::string bytes;
  std::size_t position = 0;
};

MemoryFile& FileOf(thandle_t handle) { return *static_cast<MemoryFile*>(handle); }

tmsize_t Read(thandle_t handle, void* out, tmsize_t size) {
  MemoryFile& file = FileOf(handle);
  const std::size_t left = file.bytes.size() - std::min(file.position, file.bytes.size());
  const std::size_t count = std::min(static_cast<std::size_t>(size), left);
  std::memcpy(out, file.bytes.data() + file.position, count);
  file.position += count;
  return static_cast<tmsize_t>(count);
}

tmsize_t Write(thandle_t handle, void* in, tmsize_t size) {
  MemoryFile& file = FileOf(handle);
  const auto count = static_cast<std::size_t>(size);
  if (file.bytes.size() < file.position + count) file.bytes.resize(file.position + count);
  std::memcpy(file.bytes.data() + file.position, in, count);
  file.position += count;
  return size;
}

toff_t Seek(thandle_t handle, toff_t offset, int whence) {
  MemoryFile& file = FileOf(handle);
  const std::size_t base = whence == SEEK_SET   ? 0
                           : whence == SEEK_CUR ? file.position
                                                : file.bytes.size();
  file.position = base + offset;
  return file.position;
}

toff_t Size(thandle_t handle) { return FileOf(handle).bytes.size(); }
int Close(thandle_t) { return 0; }

}  // namespace

std::string EncodeFloatTiff(const float* values, int width_px, int height_px) {
  MemoryFile file;
  std::unique_ptr<TIFF, void (*)(TIFF*)> tiff(
      TIFFClientOpen("depth", "w", &file, Read, Write, Seek, Close, Size, nullptr, nullptr),
      TIFFClose);
  Require(tiff != nullptr, "TIFF: libtiff cannot start a file");
  TIFF* out = tiff.get();
  TIFFSetField(out, TIFFTAG_IMAGEWIDTH, width_px);
  TIFFSetField(out, TIFFTAG_IMAGELENGTH, height_px);
  TIFFSetField(out, TIFFTAG_BITSPERSAMPLE, 32);
  TIFFSetField(out, TIFFTAG_SAMPLESPERPIXEL, 1);
  TIFFSetField(out, TIFFTAG_SAMPLEFORMAT, SAMPLEFORMAT_IEEEFP);
  TIFFSetField(out, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISBLACK);
  TIFFSetField(out, TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG);
  TIFFSetField(out, TIFFTAG_COMPRESSION, COMPRESSION_ADOBE_DEFLATE);
  TIFFSetField(out, TIFFTAG_PREDICTOR, PREDICTOR_FLOATINGPOINT);
  TIFFSetField(out, TIFFTAG_ZIPQUALITY, 3);
  TIFFSetField(out, TIFFTAG_ROWSPERSTRIP, height_px);
  // A copy, because the predictor modifies the data in place.
  std::vector<float> copy(values, values + static_cast<std::ptrdiff_t>(width_px) * height_px);
  const auto size = static_cast<tmsize_t>(copy.size() * sizeof(float));
  Require(TIFFWriteEncodedStrip(out, 0, copy.data(), size) == size && TIFFFlush(out) == 1,
          "TIFF: libtiff cannot encode an image");
  tiff.reset();
  return std::move(file.bytes);
}

}  // namespace cvo::synth
