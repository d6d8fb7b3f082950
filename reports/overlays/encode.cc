// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/overlays/encode.h"

#include <vector>

#include "core/base/error.h"
#include "core/files/images/image_codec.h"

namespace cvo::reports {
namespace {

std::string Encode(const cv::Mat& image, const char* extension, const std::vector<int>& settings) {
  try {
    return EncodeImage(extension, image, settings);
  } catch (const cv::Exception& error) {
    ThrowError(StrCat("an image to write as ", extension), error.err, "one that OpenCV can write");
  }
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
