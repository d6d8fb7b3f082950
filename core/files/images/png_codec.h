// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core/mat.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace cvo {

// PNG files through libpng: grey and colour (blue, green, red) of 8 or 16 bits, without palette or
// transparency. For everything else the functions return nothing.

// As cv::imdecode with IMREAD_UNCHANGED. Empty for other kinds of image, for damaged files and, if
// `only_grey`, for colour and 16 bits.
cv::Mat DecodePng(std::string_view bytes, bool only_grey = false);

// The same bytes as cv::imencode. `settings` are pairs of IMWRITE_PNG_COMPRESSION or
// IMWRITE_PNG_STRATEGY and a value. Empty for other images and settings.
std::string EncodePng(const cv::Mat& image, const std::vector<int>& settings);

}  // namespace cvo
