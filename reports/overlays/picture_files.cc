// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/overlays/picture_files.h"

#include <algorithm>
#include <opencv2/core/utils/logger.hpp>
#include <system_error>

#include "core/base/error.h"
#include "core/files/images/image_file.h"
#include "reports/overlays/canvas.h"

namespace cvo::reports {
namespace {

struct Format {
  const char* name;
  const char* extension;
  const char* code;
  int backend;
};

constexpr Format kFormats[] = {{"MP4 (H.264)", ".mp4", "avc1", cv::CAP_FFMPEG},
                               {"WebM (VP9)", ".webm", "VP90", cv::CAP_FFMPEG},
                               {"WebM (VP8)", ".webm", "VP80", cv::CAP_FFMPEG},
                               {"AVI (Motion JPEG)", ".avi", "MJPG", cv::CAP_OPENCV_MJPEG}};

}  // namespace

cv::Mat Grid(const std::vector<cv::Mat>& images, int columns) {
  constexpr int kGap_px = 4;
  Require(!images.empty() && columns > 0, "Grid: at least one image and one column");
  const cv::Size size = images.front().size();
  const int count = static_cast<int>(images.size());
  columns = std::min(columns, count);
  const int rows = (count + columns - 1) / columns;
  cv::Mat grid(rows * (size.height + kGap_px) - kGap_px, columns * (size.width + kGap_px) - kGap_px,
               CV_8UC3, Bgr(kWhite));
  for (int i = 0; i < rows * columns; ++i) {
    const cv::Point corner(i % columns * (size.width + kGap_px),
                           i / columns * (size.height + kGap_px));
    cv::Mat cell = grid(cv::Rect(corner, size));
    if (i >= count) {
      cell.setTo(Bgr(kDark));
      continue;
    }
    const cv::Mat& image = images[static_cast<std::size_t>(i)];
    if (image.size() != size) {
      ThrowError("images side by side", StrCat(image.cols, "x", image.rows, " pixels"),
                 StrCat(size.width, "x", size.height, ", as the first has"));
    }
    image.copyTo(cell);
  }
  return grid;
}

std::vector<std::size_t> EvenlySpaced(std::size_t count, std::size_t most) {
  std::vector<std::size_t> indices;
  const std::size_t chosen = std::min(count, most);
  for (std::size_t i = 0; i < chosen; ++i) {
    indices.push_back(chosen == 1 ? 0 : i * (count - 1) / (chosen - 1));
  }
  return indices;
}

std::string PngBytes(const cv::Mat& image) {
  return EncodeImage(".png", image, {cv::IMWRITE_PNG_COMPRESSION, 6});
}

std::string JpegBytes(const cv::Mat& image, int quality) {
  return EncodeImage(".jpg", image,
                     {cv::IMWRITE_JPEG_QUALITY, quality, cv::IMWRITE_JPEG_OPTIMIZE, 1});
}

VideoFile::VideoFile(const std::filesystem::path& stem, cv::Size size, double frames_per_second)
    : size_(size.width / 2 * 2, size.height / 2 * 2) {
  // No messages about unavailable formats, since the next one is tried.
  const auto level = cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT);
  for (const Format& format : kFormats) {
    path_ = stem.string() + format.extension;
    format_ = format.name;
    const char* code = format.code;
    try {
      video_.open(path_.string(), format.backend,
                  cv::VideoWriter::fourcc(code[0], code[1], code[2], code[3]), frames_per_second,
                  size_);
    } catch (const cv::Exception&) {  // not open, then
    }
    if (video_.isOpened()) break;
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
  }
  cv::utils::logging::setLogLevel(level);
  if (video_.isOpened()) return;
  ThrowError(stem.string(), "an OpenCV that writes no video here",
             "one with H.264, VP9, VP8 or Motion JPEG");
}

void VideoFile::Add(const cv::Mat& image) {
  const cv::Rect kept({}, size_);
  if ((cv::Rect({}, image.size()) & kept) != kept) {
    ThrowError(path_.string(), StrCat("a frame of ", image.cols, "x", image.rows, " pixels"),
               StrCat(size_.width, "x", size_.height));
  }
  video_.write(image(kept));
}

void VideoFile::Close() {
  video_.release();
  std::error_code error;
  if (std::filesystem::file_size(path_, error) == 0 || error) {
    ThrowError(path_.string(), "a video of which nothing was written", "room for it");
  }
}

}  // namespace cvo::reports
