// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core/mat.hpp>
#include <string>

namespace cvo::reports {

// The bytes of an image file; the same for the same image. Throws Error where it cannot be made.
std::string PngBytes(const cv::Mat& image);
// `quality`: 0 to 100.
std::string JpegBytes(const cv::Mat& image, int quality);

}  // namespace cvo::reports
