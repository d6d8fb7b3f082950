// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "synth/write/image_encoding.h"

#include "core/base/error.h"
#include "core/files/images/image_codec.h"
#include "synth/write/memory_tiff.h"

namespace cvo::synth {

std::string EncodePng(const cv::Mat& image) {
  return EncodeImage(
      ".png", image,
      {cv::IMWRITE_PNG_COMPRESSION, 1, cv::IMWRITE_PNG_STRATEGY, cv::IMWRITE_PNG_STRATEGY_RLE});
}

std::string EncodeMaskPng(const cv::Mat& image) {
  return EncodeImage(".png", image, {cv::IMWRITE_PNG_COMPRESSION, 1});
}

std::string EncodeDepthTiff(const cv::Mat& depth) {
  Require(depth.type() == CV_32FC1, "EncodeDepthTiff: depth must be CV_32FC1");
  const cv::Mat rows = depth.isContinuous() ? depth : depth.clone();
  return EncodeFloatTiff(rows.ptr<float>(), rows.cols, rows.rows);
}

}  // namespace cvo::synth
