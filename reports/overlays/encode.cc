// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/overlays/encode.h"

#include "core/files/images/image_codec.h"

namespace cvo::reports {

std::string PngBytes(const cv::Mat& image) {
  return EncodeImage(".png", image, {cv::IMWRITE_PNG_COMPRESSION, 6});
}

std::string JpegBytes(const cv::Mat& image, int quality) {
  return EncodeImage(".jpg", image,
                     {cv::IMWRITE_JPEG_QUALITY, quality, cv::IMWRITE_JPEG_OPTIMIZE, 1,
                      cv::IMWRITE_JPEG_PROGRESSIVE, 0});
}

}  // namespace cvo::reports
