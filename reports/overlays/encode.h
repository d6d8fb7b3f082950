// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core/mat.hpp>
#include <string>

namespace cvo::reports {

// Encode an image as the bytes of a PNG or JPEG file. Equal images give equal bytes. Throw Error if
// OpenCV cannot encode the image.
std::string PngBytes(const cv::Mat& image);
// `quality`: 0 to 100.
std::string JpegBytes(const cv::Mat& image, int quality);

}  // namespace cvo::reports
