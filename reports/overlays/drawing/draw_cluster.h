// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core/mat.hpp>
#include <optional>

#include "reports/overlays/drawing/draw_overlay.h"
#include "reports/overlays/drawing/palette.h"
#include "reports/overlays/drawing/project.h"
#include "reports/overlays/drawing/strokes.h"

namespace cvo::reports {

// The following functions draw all clusters of a frame, each one aspect of them. `camera` is the
// camera scaled to the picture.

// Fills the boxes of predicted clusters, translucently.
void FillGhosts(const OverlayFrame& frame, const CameraInfo& camera, cv::Mat& picture);
void DrawBoxes(const OverlayFrame& frame, const CameraInfo& camera, const OverlayStyle& style,
               cv::Mat& picture);
// Draws the trails and the motion arrows.
void DrawMotion(const OverlayFrame& frame, const CameraInfo& camera, const OverlayStyle& style,
                cv::Mat& picture);
// Draws ids and classes beside the boxes. Where there is room, a name covers neither another name,
// another box, a rectangle in `taken`, nor landmarks on bodies. A line connects a name to its box
// if they are apart.
void DrawNames(const OverlayFrame& frame, const CameraInfo& camera, const OverlayStyle& style,
               const std::vector<cv::Rect>& taken, cv::Mat& picture);

// Appends a path that widens towards its end.
void AddTrail(const std::vector<cv::Point2d>& path, Rgb color, int width_px,
              std::vector<Stroke>& strokes);
// Appends an arrow, or nothing if it is shorter than `shortest_px`.
void AddArrow(const PixelSegment& shaft, Rgb color, int line_px, double shortest_px,
              std::vector<Stroke>& strokes);

Rgb ColorOf(const OverlayFrame& frame, std::int64_t id);

// The part of the picture that a cluster's box covers. Empty if the box is out of view.
[[nodiscard]] std::optional<cv::Rect> SeenRect(const ClusterShape& cluster,
                                               const CameraInfo& camera);

}  // namespace cvo::reports
