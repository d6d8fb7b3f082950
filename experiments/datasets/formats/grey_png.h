// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core/mat.hpp>
#include <string_view>

namespace cvo {

// CV_8UC1: what a whole PNG file shows (FindPngDamage), if it is one of 8 bits of grey, not
// interlaced and without transparency, as stereo pairs are. Empty for any other, which OpenCV
// reads, and where the pixels do not inflate to the image's size. Half as long as OpenCV takes:
// decoding was a seventh of a run.
cv::Mat DecodeGreyPng(std::string_view bytes);

}  // namespace cvo
