// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core/mat.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "reports/overlays/drawing/palette.h"

namespace cvo::reports {

cv::Scalar Bgr(Rgb color);

// Makes arbitrary text drawable: keeps printable ASCII, replaces every other character by '?', and
// truncates the text with ".." if it is longer than `longest`.
std::string DrawableText(std::string_view text, std::size_t longest);

struct PlateStyle {
  int text_px = 9;  // height of a capital letter
  Rgb fill;
  Rgb ink;
  double opacity = 1.0;  // of the fill
  std::optional<Rgb> outline = {};
};

// The size of a plate with this text.
cv::Size PlateSize(const std::string& text, int text_px);

// Draws text on a filled rectangle whose top left corner is at `at`. Whatever is outside the image
// is clipped.
void DrawPlate(const std::string& text, cv::Point at, const PlateStyle& style, cv::Mat& image);

// Blends a colour into the image: image = (1 - w) * image + w * color, with w = opacity * mask /
// 255, where the mask, whose top left corner is at `at`, covers the image.
void BlendMask(const cv::Mat& mask, cv::Point at, Rgb color, double opacity, cv::Mat& image);

}  // namespace cvo::reports
