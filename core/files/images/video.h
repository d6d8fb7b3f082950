// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <memory>
#include <opencv2/videoio.hpp>  // the constants
#include <string>

namespace cvo {

// Video files through OpenCV, whose library for them is loaded at the first use (see FindSymbol).
// The functions of that library itself are not linked. All may throw cv::Exception.

class VideoReader {
 public:
  explicit VideoReader(const std::string& file);
  ~VideoReader();
  bool ok() const;  // whether the file could be opened
  // `property` is one of cv::VideoCaptureProperties. Returns 0 for one that is not known.
  double Get(int property) const;
  // Returns the next frame in colour; empty after the last one.
  cv::Mat Next();

 private:
  std::unique_ptr<cv::VideoCapture> video_;
};

class VideoWriter {
 public:
  // `backend` is one of cv::VideoCaptureAPIs, `code` names the compression, as in "avc1".
  VideoWriter(const std::string& file, int backend, const std::array<char, 4>& code,
              double frames_per_second, cv::Size size);
  ~VideoWriter();
  bool ok() const;  // whether the file could be opened
  void Add(const cv::Mat& image);
  void Close();

 private:
  std::unique_ptr<cv::VideoWriter> video_;
};

}  // namespace cvo
