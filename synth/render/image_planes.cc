// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <opencv2/core.hpp>

#include "core/base/error.h"
#include "synth/render/renderer.h"

namespace cvo::synth {

cv::Mat LumaOf(const cv::Mat& image) {
  Require(image.type() == CV_8UC4, "an image of the renderer has four channels");
  cv::Mat luma;
  cv::extractChannel(image, luma, 3);
  return luma;
}

cv::Mat ColourOf(const cv::Mat& image) {
  Require(image.type() == CV_8UC4, "an image of the renderer has four channels");
  cv::Mat colour(image.size(), CV_8UC3);
  cv::mixChannels({image}, {colour}, {0, 2, 1, 1, 2, 0});
  return colour;
}

}  // namespace cvo::synth
