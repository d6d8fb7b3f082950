// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>
#include <opencv2/core/mat.hpp>
#include <string>

#include "core/files/images/video.h"

namespace cvo::reports {

// A video file in the first of these formats that OpenCV can write on this machine: MP4 (H.264),
// WebM (VP9, VP8), AVI (Motion JPEG). The file is complete once Close has returned.
class VideoFile {
 public:
  // Writes <stem>.mp4, .webm or .avi. Throws Error if no format can be written. An odd width or
  // height loses its last column or row, since H.264 requires even sizes.
  VideoFile(const std::filesystem::path& stem, cv::Size size, double frames_per_second);

  void Add(const cv::Mat& image);
  void Close();

  const std::filesystem::path& path() const { return path_; }
  const std::string& format() const { return format_; }  // "MP4 (H.264)"

 private:
  std::unique_ptr<VideoWriter> video_;
  std::filesystem::path path_;
  std::string format_;
  cv::Size size_;
};

}  // namespace cvo::reports
