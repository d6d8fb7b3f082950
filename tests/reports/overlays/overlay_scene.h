// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core.hpp>

#include "reports/overlays/drawing/draw_overlay.h"
#include "reports/overlays/drawing/palette.h"

namespace cvo::test {

inline constexpr std::uint8_t kGrey = 90;

// A uniform image and its camera: a point at (x, y, 2) m is 100 x px right of the centre.
inline reports::CameraInfo FlatCamera() { return {320, 240, 200.0, 200.0, 160.0, 120.0}; }
inline cv::Mat FlatImage() { return cv::Mat(240, 320, CV_8UC1, cv::Scalar(kGrey)); }

// Thin lines and nothing below the image.
inline reports::OverlayStyle PlainStyle() {
  reports::OverlayStyle style;
  style.line_px = 1;
  style.status = false;
  return style;
}

// A static cube of 1 m edge length, with its near face at depth `near_z` and its centre 0.5 m
// behind that.
inline reports::ClusterShape Cube(std::int64_t id, double x = 0.0, double near_z = 2.0) {
  reports::ClusterShape cube;
  cube.id = id;
  cube.category = "Crate";
  for (std::size_t i = 0; i < 8; ++i) {
    cube.corners[i] = {x + ((i & 1U) != 0 ? 0.5 : -0.5), (i & 2U) != 0 ? 0.5 : -0.5,
                       near_z + ((i & 4U) != 0 ? 1.0 : 0.0)};
  }
  cube.center = {x, 0.0, near_z + 0.5};
  cube.ahead = cube.center;
  return cube;
}

inline reports::Rgb ColorAt(const cv::Mat& picture, int u, int v) {
  const auto& bgr = picture.at<cv::Vec3b>(v, u);
  return {bgr[2], bgr[1], bgr[0]};
}

// Number of pixels of exactly this colour.
inline int CountColor(const cv::Mat& picture, reports::Rgb color) {
  int count = 0;
  for (int v = 0; v < picture.rows; ++v) {
    for (int u = 0; u < picture.cols; ++u) count += ColorAt(picture, u, v) == color ? 1 : 0;
  }
  return count;
}

inline bool SameImage(const cv::Mat& a, const cv::Mat& b) {
  return a.size() == b.size() && a.type() == b.type() && cv::norm(a, b, cv::NORM_INF) == 0.0;
}

}  // namespace cvo::test
