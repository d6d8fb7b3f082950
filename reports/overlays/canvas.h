// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core/mat.hpp>
#include <string>
#include <utility>
#include <vector>

#include "reports/overlays/overlay_run.h"

namespace cvo::reports {

// The marks that pictures consist of. Pixel centres are at integers. What lies outside the image,
// however far, is cut off; what is not finite is not drawn.

inline constexpr Rgb kDark{20, 21, 25};
inline constexpr Rgb kWhite{255, 255, 255};

using Segment = std::pair<cv::Point2d, cv::Point2d>;

struct Stroke {
  Segment segment;
  Rgb color;
  int width_px = 1;
  bool dashed = false;
};

// Draws lines with dark rims, which are visible on any background. All rims are drawn first, so
// that none covers another stroke.
void DrawStrokes(const std::vector<Stroke>& strokes, cv::Mat& image);

// Appends a path that widens towards its end.
void AddTail(const std::vector<Segment>& path, Rgb color, int width_px,
             std::vector<Stroke>& strokes);

// A filled circle with smoothed edges.
void DrawDisc(cv::Point2d center, double radius_px, Rgb color, cv::Mat& image);

// The size of letters, and of the gap that is left around a text.
struct Font {
  explicit Font(int text_px);  // height of a capital letter

  cv::Size SizeOf(const std::string& text) const;  // with the gap

  double scale;
  int thickness;
  int gap_px;
};

void DrawText(const std::string& text, cv::Point top_left, const Font& font, Rgb color,
              cv::Mat& image);

// Draws text on a filled rectangle, moved into the image.
void DrawPlate(const std::string& text, cv::Point top_left, int text_px, Rgb fill, cv::Mat& image);

cv::Scalar Bgr(Rgb color);

}  // namespace cvo::reports
