// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/overlays/drawing/strokes.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "reports/overlays/drawing/text_plate.h"

namespace cvo::reports {
namespace {

constexpr int kFractionBits = 4;  // fractional bits of pixel coordinates
constexpr double kClipMargin_px = 50.0;

cv::Point Fixed(cv::Point2d point) {
  constexpr double kOne = 1 << kFractionBits;
  // A hull may extend to the near plane, far outside the image.
  constexpr double kFarthest_px = 20000.0;
  const auto fixed = [&](double pixel) {
    return static_cast<int>(std::lround(std::clamp(pixel, -kFarthest_px, kFarthest_px) * kOne));
  };
  return {fixed(point.x), fixed(point.y)};
}

bool IsWhole(double pixel) { return pixel == std::floor(pixel); }

// Horizontal and vertical lines on whole pixels are drawn sharp; all others are antialiased.
bool IsSharp(const PixelSegment& segment) {
  const auto& [a, b] = segment;
  return IsWhole(a.x) && IsWhole(a.y) && IsWhole(b.x) && IsWhole(b.y) && (a.x == b.x || a.y == b.y);
}

void DrawLine(const PixelSegment& segment, const cv::Scalar& color, int width_px, cv::Mat& image) {
  cv::line(image, Fixed(segment.first), Fixed(segment.second), color, width_px,
           IsSharp(segment) ? cv::LINE_8 : cv::LINE_AA, kFractionBits);
}

// Coverage, 0 to 255, of a pixel whose centre lies this far inside an edge.
std::uint8_t Covered(double inside_px) {
  return static_cast<std::uint8_t>(std::lround(255.0 * std::clamp(inside_px + 0.5, 0.0, 1.0)));
}

}  // namespace

std::vector<PixelSegment> Dashes(const PixelSegment& segment, double dash_px, double gap_px) {
  const cv::Point2d step = segment.second - segment.first;
  const double length_px = std::hypot(step.x, step.y);
  if (!(length_px > dash_px)) return {segment};
  std::vector<PixelSegment> dashes;
  for (double begin_px = 0.0; begin_px < length_px; begin_px += dash_px + gap_px) {
    const double end_px = std::min(begin_px + dash_px, length_px);
    dashes.emplace_back(segment.first + begin_px / length_px * step,
                        segment.first + end_px / length_px * step);
  }
  return dashes;
}

void DrawStrokes(const std::vector<Stroke>& strokes, double rim_opacity, cv::Mat& image) {
  std::vector<Stroke> seen;
  for (const Stroke& stroke : strokes) {
    const auto segment = ClipSegment(stroke.segment, image.size(), kClipMargin_px);
    if (segment) seen.push_back({*segment, stroke.color, stroke.width_px});
  }
  if (seen.empty()) return;
  cv::Mat rim = cv::Mat::zeros(image.size(), CV_8UC1);
  for (const Stroke& stroke : seen) DrawLine(stroke.segment, 255, stroke.width_px + 2, rim);
  BlendMask(rim, {}, {}, rim_opacity, image);
  for (const Stroke& stroke : seen) {
    DrawLine(stroke.segment, Bgr(stroke.color), stroke.width_px, image);
  }
}

void DrawDisc(cv::Point2d center, double radius_px, double rim_px, Rgb color, cv::Mat& image) {
  const double reach_px = radius_px + rim_px + 1.0;
  // Written so that NaN is outside, too.
  if (!(center.x > -reach_px && center.y > -reach_px && center.x < image.cols + reach_px &&
        center.y < image.rows + reach_px)) {
    return;
  }
  const cv::Point corner(static_cast<int>(std::floor(center.x - reach_px)),
                         static_cast<int>(std::floor(center.y - reach_px)));
  const int side_px = static_cast<int>(std::ceil(2.0 * reach_px)) + 2;
  cv::Mat rim(side_px, side_px, CV_8UC1);
  cv::Mat disc(side_px, side_px, CV_8UC1);
  for (int v = 0; v < side_px; ++v) {
    for (int u = 0; u < side_px; ++u) {
      const double away_px = std::hypot(u + corner.x - center.x, v + corner.y - center.y);
      rim.at<std::uint8_t>(v, u) = Covered(radius_px + rim_px - away_px);
      disc.at<std::uint8_t>(v, u) = Covered(radius_px - away_px);
    }
  }
  if (rim_px > 0.0) BlendMask(rim, corner, {}, kRimOpacity, image);
  BlendMask(disc, corner, color, 1.0, image);
}

void FillHull(const std::vector<cv::Point2d>& points, Rgb color, double opacity, cv::Mat& image) {
  if (points.size() < 3) return;
  std::vector<cv::Point> fixed;
  for (const cv::Point2d& point : points) fixed.push_back(Fixed(point));
  std::vector<cv::Point> hull;
  cv::convexHull(fixed, hull);
  if (hull.size() < 3) return;
  cv::Mat mask = cv::Mat::zeros(image.size(), CV_8UC1);
  cv::fillConvexPoly(mask, hull, 255, cv::LINE_AA, kFractionBits);
  BlendMask(mask, {}, color, opacity, image);
}

}  // namespace cvo::reports
