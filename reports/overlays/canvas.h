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

// Where marks are drawn: on the pixels or, if `svg` is set, appended to it as elements over them.
struct Canvas {
  cv::Mat pixels;
  std::string* svg = nullptr;
};

using Segment = std::pair<cv::Point2d, cv::Point2d>;

struct Stroke {
  Segment segment;
  Rgb color;
  int width_px = 1;
  bool dashed = false;
};

// Draws lines with dark rims, which are visible on any background. All rims are drawn first, so
// that none covers another stroke.
void DrawStrokes(const std::vector<Stroke>& strokes, Canvas& canvas);

// Appends a path that widens towards its end.
void AddTail(const std::vector<Segment>& path, Rgb color, int width_px,
             std::vector<Stroke>& strokes);

// A filled circle with smoothed edges.
void DrawDisc(cv::Point2d center, double radius_px, Rgb color, Canvas& canvas);

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
void DrawPlate(const std::string& text, cv::Point top_left, int text_px, Rgb fill, Canvas& canvas);

cv::Scalar Bgr(Rgb color);

// Arranges images of one size in rows, starting at the top left. Throws Error for images of
// different sizes.
cv::Mat Grid(const std::vector<cv::Mat>& images, int columns);

// Returns at most `most` of `count` indices, evenly spaced from the first to the last.
std::vector<std::size_t> EvenlySpaced(std::size_t count, std::size_t most);

// Encode an image as the bytes of a PNG or JPEG file. Equal images give equal bytes. Throw Error if
// OpenCV cannot encode the image.
std::string PngBytes(const cv::Mat& image);
std::string JpegBytes(const cv::Mat& image, int quality);  // 0 to 100

}  // namespace cvo::reports
