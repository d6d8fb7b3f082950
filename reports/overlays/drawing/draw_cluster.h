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

// Each draws its part of all clusters of a frame; `camera` is that of the picture.
void FillGhosts(const OverlayFrame& frame, const CameraInfo& camera, cv::Mat& picture);
void DrawBoxes(const OverlayFrame& frame, const CameraInfo& camera, const OverlayStyle& style,
               cv::Mat& picture);
// Trails and arrows.
void DrawMotion(const OverlayFrame& frame, const CameraInfo& camera, const OverlayStyle& style,
                cv::Mat& picture);
// Ids and classes beside the boxes; where there is room, not over each other, over what is taken or
// over landmarks of bodies. A line leads to a name that is away from its box.
void DrawNames(const OverlayFrame& frame, const CameraInfo& camera, const OverlayStyle& style,
               const std::vector<cv::Rect>& taken, cv::Mat& picture);

// A path that grows wider towards its end.
void AddTrail(const std::vector<cv::Point2d>& path, Rgb color, int width_px,
              std::vector<Stroke>& strokes);
// With a head; nothing where it is shorter than `shortest_px`.
void AddArrow(const PixelSegment& shaft, Rgb color, int line_px, double shortest_px,
              std::vector<Stroke>& strokes);

Rgb ColorOf(const OverlayFrame& frame, std::int64_t id);

// The part of the picture that a cluster's box covers; empty where it is out of view.
[[nodiscard]] std::optional<cv::Rect> SeenRect(const ClusterShape& cluster,
                                               const CameraInfo& camera);

}  // namespace cvo::reports
