// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/overlays/video.h"

#include <array>
#include <opencv2/core/utils/logger.hpp>
#include <system_error>

#include "core/base/error.h"

namespace cvo::reports {
namespace {

struct Format {
  const char* name;
  const char* extension;
  std::array<char, 4> code;
  int backend;
};

constexpr std::array<Format, 4> kFormats = {
    {{"MP4 (H.264)", ".mp4", {'a', 'v', 'c', '1'}, cv::CAP_FFMPEG},
     {"WebM (VP9)", ".webm", {'V', 'P', '9', '0'}, cv::CAP_FFMPEG},
     {"WebM (VP8)", ".webm", {'V', 'P', '8', '0'}, cv::CAP_FFMPEG},
     {"AVI (Motion JPEG)", ".avi", {'M', 'J', 'P', 'G'}, cv::CAP_OPENCV_MJPEG}}};

// Suppresses OpenCV's messages about unavailable formats, which are tried as well.
class QuietOpenCv {
 public:
  QuietOpenCv() : level_(cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT)) {}
  ~QuietOpenCv() { cv::utils::logging::setLogLevel(level_); }
  QuietOpenCv(const QuietOpenCv&) = delete;
  QuietOpenCv& operator=(const QuietOpenCv&) = delete;

 private:
  cv::utils::logging::LogLevel level_;
};

}  // namespace

VideoFile::VideoFile(const std::filesystem::path& stem, cv::Size size, double frames_per_second)
    : size_(size.width / 2 * 2, size.height / 2 * 2) {
  const QuietOpenCv quiet;
  for (const Format& format : kFormats) {
    path_ = stem.string() + format.extension;
    format_ = format.name;
    try {
      video_ = std::make_unique<VideoWriter>(path_.string(), format.backend, format.code,
                                             frames_per_second, size_);
    } catch (const cv::Exception&) {
      continue;
    }
    if (video_->ok()) return;
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
  }
  ThrowError(stem.string(), "an OpenCV that writes no video here",
             "one with H.264, VP9, VP8 or Motion JPEG");
}

void VideoFile::Add(const cv::Mat& image) {
  const cv::Rect kept({}, size_);
  if ((cv::Rect({}, image.size()) & kept) != kept) {
    ThrowError(path_.string(), StrCat("a frame of ", image.cols, "x", image.rows, " pixels"),
               StrCat(size_.width, "x", size_.height));
  }
  video_->Add(image(kept));
}

void VideoFile::Close() {
  video_->Close();
  std::error_code error;
  if (std::filesystem::file_size(path_, error) == 0 || error) {
    ThrowError(path_.string(), "a video of which nothing was written", "room for it");
  }
}

}  // namespace cvo::reports
