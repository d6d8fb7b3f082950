// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/features/pyramid.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace cvo {
namespace {

constexpr int kRowAlignment = 64;  // bytes: a cache line

std::vector<cv::Mat> Allocate(const std::vector<cv::Size>& sizes) {
  int rows = 0;
  for (const cv::Size& size : sizes) rows += size.height;
  const int stride = (sizes[0].width + kRowAlignment - 1) / kRowAlignment * kRowAlignment;
  const cv::Mat storage(rows, stride, CV_8UC1);
  std::vector<cv::Mat> images;
  int top = 0;
  for (const cv::Size& size : sizes) {
    images.push_back(storage(cv::Rect(0, top, size.width, size.height)));
    top += size.height;
  }
  return images;
}

}  // namespace

std::vector<cv::Mat> BuildPyramid(const cv::Mat& image, int levels, double scale_factor,
                                  int min_side_px) {
  std::vector<cv::Size> sizes = {image.size()};
  for (int level = 1; level < levels; ++level) {
    const double scale = std::pow(scale_factor, -level);
    const cv::Size size(cvRound(image.cols * scale), cvRound(image.rows * scale));
    if (std::min(size.width, size.height) < min_side_px) break;
    sizes.push_back(size);
  }
  std::vector<cv::Mat> pyramid = Allocate(sizes);
  image.copyTo(pyramid[0]);
  for (std::size_t level = 1; level < pyramid.size(); ++level) {
    cv::resize(pyramid[level - 1], pyramid[level], sizes[level], 0.0, 0.0, cv::INTER_LINEAR);
  }
  return pyramid;
}

std::vector<cv::Mat> AllocateLike(const std::vector<cv::Mat>& pyramid) {
  std::vector<cv::Size> sizes;
  for (const cv::Mat& level : pyramid) sizes.push_back(level.size());
  return Allocate(sizes);
}

}  // namespace cvo
