// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core/mat.hpp>
#include <vector>

#include "reports/overlays/drawing/palette.h"
#include "reports/overlays/drawing/project.h"

namespace cvo::reports {

inline constexpr double kRimOpacity = 0.55;

// A line of the drawing. All are first underlaid with a dark rim, so that they are seen on any
// background and a rim never covers another line.
struct Stroke {
  PixelSegment segment;
  Rgb color;
  int width_px = 1;
};

// The segment as dashes.
std::vector<PixelSegment> Dashes(const PixelSegment& segment, double dash_px, double gap_px);

void DrawStrokes(const std::vector<Stroke>& strokes, double rim_opacity, cv::Mat& image);

// A filled disc with a dark rim of `rim_px` around it.
void DrawDisc(cv::Point2d center, double radius_px, double rim_px, Rgb color, cv::Mat& image);

// The convex hull of the points, translucent.
void FillHull(const std::vector<cv::Point2d>& points, Rgb color, double opacity, cv::Mat& image);

}  // namespace cvo::reports
