// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core/mat.hpp>
#include <vector>

#include "reports/overlays/drawing/palette.h"
#include "reports/overlays/drawing/project.h"

namespace cvo::reports {

inline constexpr double kRimOpacity = 0.55;

// A line of the drawing. The dark rims of all strokes are drawn before the first stroke, so that
// strokes are visible on any background and no rim covers another stroke.
struct Stroke {
  PixelSegment segment;
  Rgb color;
  int width_px = 1;
};

// Splits a segment into dashes.
std::vector<PixelSegment> Dashes(const PixelSegment& segment, double dash_px, double gap_px);

void DrawStrokes(const std::vector<Stroke>& strokes, double rim_opacity, cv::Mat& image);

// Draws a filled disc with a dark rim of `rim_px` around it.
void DrawDisc(cv::Point2d center, double radius_px, double rim_px, Rgb color, cv::Mat& image);

// Fills the convex hull of the points, translucently.
void FillHull(const std::vector<cv::Point2d>& points, Rgb color, double opacity, cv::Mat& image);

}  // namespace cvo::reports
