// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core/mat.hpp>
#include <string_view>

namespace cvo {

// CV_8UC1: what a PNG file of 8 bits of grey shows that is not interlaced and has no transparency,
// as stereo pairs are. Empty for any other bytes, other kinds of PNG file included, and where the
// pixels do not inflate to the image's size; checksums are FindPngDamage's. Takes half as long as
// OpenCV, whose decoding was a seventh of a run.
cv::Mat DecodeGreyPng(std::string_view bytes);

}  // namespace cvo
