// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <opencv2/core/mat.hpp>
#include <opencv2/videoio.hpp>
#include <string>
#include <vector>

namespace cvo::reports {

// Arranges images of one size in rows, starting at the top left. Throws Error for images of
// different sizes.
cv::Mat Grid(const std::vector<cv::Mat>& images, int columns);

// Returns at most `most` of `count` indices, evenly spaced from the first to the last.
std::vector<std::size_t> EvenlySpaced(std::size_t count, std::size_t most);

// Encode an image as the bytes of a PNG or JPEG file. Equal images give equal bytes. Throw Error if
// OpenCV cannot encode the image.
std::string PngBytes(const cv::Mat& image);
std::string JpegBytes(const cv::Mat& image, int quality);  // 0 to 100

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
  cv::VideoWriter video_;
  std::filesystem::path path_;
  std::string format_;
  cv::Size size_;
};

}  // namespace cvo::reports
