// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/overlays/encode.h"

#include <opencv2/imgcodecs.hpp>
#include <vector>

#include "core/base/error.h"

namespace cvo::reports {
namespace {

std::string Encode(const cv::Mat& image, const char* extension, const std::vector<int>& settings) {
  std::vector<unsigned char> bytes;
  bool done = false;
  try {
    done = cv::imencode(extension, image, bytes, settings);
  } catch (const cv::Exception& error) {
    ThrowError(StrCat("an image to write as ", extension), error.err, "one that OpenCV can write");
  }
  if (!done) {
    ThrowError(StrCat("an image to write as ", extension), "an OpenCV without this format", "one");
  }
  return {bytes.begin(), bytes.end()};
}

}  // namespace

std::string PngBytes(const cv::Mat& image) {
  return Encode(image, ".png", {cv::IMWRITE_PNG_COMPRESSION, 6});
}

std::string JpegBytes(const cv::Mat& image, int quality) {
  return Encode(image, ".jpg",
                {cv::IMWRITE_JPEG_QUALITY, quality, cv::IMWRITE_JPEG_OPTIMIZE, 1,
                 cv::IMWRITE_JPEG_PROGRESSIVE, 0});
}

}  // namespace cvo::reports
