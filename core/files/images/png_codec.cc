// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/files/images/png_codec.h"

#include <png.h>

#include <bit>
#include <cstring>
#include <opencv2/imgcodecs.hpp>  // the settings
#include <optional>

#include "core/files/images/image_limits.h"

namespace cvo {
namespace {

struct PngError {};

[[noreturn]] void Throw(png_structp, png_const_charp) { throw PngError(); }
void Ignore(png_structp, png_const_charp) {}

// The structures of a file that is read or written. libpng lets its caller leave by an exception;
// distributions build it with the tables to unwind.
class Png {
 public:
  explicit Png(bool reads)
      : reads_(reads),
        file_((reads ? png_create_read_struct : png_create_write_struct)(PNG_LIBPNG_VER_STRING,
                                                                         nullptr, Throw, Ignore)),
        info_(png_create_info_struct(file_)) {}
  ~Png() {
    if (reads_) {
      png_destroy_read_struct(&file_, &info_, nullptr);
    } else {
      png_destroy_write_struct(&file_, &info_);
    }
  }
  Png(const Png&) = delete;
  Png& operator=(const Png&) = delete;

  png_structp file() const { return file_; }
  png_infop info() const { return info_; }

 private:
  bool reads_;
  png_structp file_;
  png_infop info_;
};

void ReadNext(png_structp file, png_bytep out, std::size_t size) {
  auto& left = *static_cast<std::string_view*>(png_get_io_ptr(file));
  if (size > left.size()) throw PngError();
  std::memcpy(out, left.data(), size);
  left.remove_prefix(size);
}

void Append(png_structp file, png_bytep bytes, std::size_t size) {
  static_cast<std::string*>(png_get_io_ptr(file))->append(reinterpret_cast<char*>(bytes), size);
}

std::vector<png_bytep> RowsOf(const cv::Mat& image) {
  std::vector<png_bytep> rows;
  for (int v = 0; v < image.rows; ++v) rows.push_back(const_cast<png_bytep>(image.ptr(v)));
  return rows;
}

// Rows in the memory order of OpenCV: blue first, and words as the processor has them.
void SetOrder(const Png& png, bool colour, bool words) {
  if (colour) png_set_bgr(png.file());
  if (words && std::endian::native == std::endian::little) png_set_swap(png.file());
}

// Returns the type of OpenCV's image. Empty for kinds of file that are not decoded here.
std::optional<int> TypeOf(const Png& png) {
  const int bits = png_get_bit_depth(png.file(), png.info());
  const int colour = png_get_color_type(png.file(), png.info());
  const bool known = (bits == 8 || bits == 16) &&
                     (colour == PNG_COLOR_TYPE_GRAY || colour == PNG_COLOR_TYPE_RGB) &&
                     png_get_valid(png.file(), png.info(), PNG_INFO_tRNS) == 0;
  if (!known) return std::nullopt;
  return CV_MAKETYPE(bits == 8 ? CV_8U : CV_16U, colour == PNG_COLOR_TYPE_RGB ? 3 : 1);
}

struct Settings {
  std::optional<int> level;
  int strategy = cv::IMWRITE_PNG_STRATEGY_RLE;
};

std::optional<Settings> ReadSettings(const std::vector<int>& pairs) {
  Settings settings;
  for (std::size_t i = 0; i + 1 < pairs.size(); i += 2) {
    if (pairs[i] == cv::IMWRITE_PNG_COMPRESSION) {
      settings = {pairs[i + 1], cv::IMWRITE_PNG_STRATEGY_DEFAULT};
    } else if (pairs[i] == cv::IMWRITE_PNG_STRATEGY) {
      settings.strategy = pairs[i + 1];
    } else {
      return std::nullopt;
    }
  }
  return settings;
}

void SetCompression(const Png& png, const Settings& settings) {
  if (!settings.level) png_set_filter(png.file(), PNG_FILTER_TYPE_BASE, PNG_FILTER_SUB);
  png_set_compression_level(png.file(), settings.level.value_or(1));
  png_set_compression_strategy(png.file(), settings.strategy);
}

}  // namespace

cv::Mat DecodePng(std::string_view bytes, bool only_grey) {
  try {
    const Png png(true);
    if (png.file() == nullptr) return {};
    std::string_view left = bytes;
    png_set_read_fn(png.file(), &left, ReadNext);
    png_set_user_limits(png.file(), kMaxSide_px, kMaxSide_px);
    png_read_info(png.file(), png.info());
    const std::optional<int> type = TypeOf(png);
    if (!type || (only_grey && *type != CV_8UC1)) return {};
    const cv::Size size(static_cast<int>(png_get_image_width(png.file(), png.info())),
                        static_cast<int>(png_get_image_height(png.file(), png.info())));
    const std::size_t pixels = static_cast<std::size_t>(size.width) * size.height;
    if (!CanHold(bytes.size(), pixels * CV_ELEM_SIZE(*type))) return {};
    SetOrder(png, CV_MAT_CN(*type) == 3, CV_MAT_DEPTH(*type) == CV_16U);
    png_set_interlace_handling(png.file());
    png_read_update_info(png.file(), png.info());
    cv::Mat image(size, *type);
    png_read_image(png.file(), RowsOf(image).data());
    png_read_end(png.file(), nullptr);
    return image;
  } catch (const PngError&) {
    return {};
  }
}

std::string EncodePng(const cv::Mat& image, const std::vector<int>& settings) {
  const std::optional<Settings> compression = ReadSettings(settings);
  const bool words = image.depth() == CV_16U;
  const bool colour = image.channels() == 3;
  if (!compression || image.empty() || (image.depth() != CV_8U && !words) ||
      (image.channels() != 1 && !colour)) {
    return {};
  }
  try {
    std::string bytes;
    const Png png(false);
    if (png.file() == nullptr) return {};
    png_set_write_fn(png.file(), &bytes, Append, nullptr);
    SetCompression(png, *compression);
    png_set_IHDR(png.file(), png.info(), static_cast<png_uint_32>(image.cols),
                 static_cast<png_uint_32>(image.rows), words ? 16 : 8,
                 colour ? PNG_COLOR_TYPE_RGB : PNG_COLOR_TYPE_GRAY, PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_write_info(png.file(), png.info());
    SetOrder(png, colour, words);
    png_write_image(png.file(), RowsOf(image).data());
    png_write_end(png.file(), png.info());
    return bytes;
  } catch (const PngError&) {
    return {};
  }
}

}  // namespace cvo
