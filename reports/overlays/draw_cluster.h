// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core/mat.hpp>
#include <optional>

#include "reports/overlays/draw_overlay.h"
#include "reports/overlays/palette.h"
#include "reports/overlays/project.h"

namespace cvo::reports {

// Each draws its part of all clusters of a frame; `camera` is that of the picture.
void FillGhosts(const OverlayFrame& frame, const CameraInfo& camera, cv::Mat& picture);
void DrawBoxes(const OverlayFrame& frame, const CameraInfo& camera, const OverlayStyle& style,
               cv::Mat& picture);
// Trails and arrows.
void DrawMotion(const OverlayFrame& frame, const CameraInfo& camera, const OverlayStyle& style,
                cv::Mat& picture);
// Ids and classes, beside the boxes and not over each other where there is room.
void DrawNames(const OverlayFrame& frame, const CameraInfo& camera, const OverlayStyle& style,
               cv::Mat& picture);

Rgb ColorOf(const OverlayFrame& frame, std::int64_t id);

// The part of the picture that a cluster's box covers; empty where it is out of view.
[[nodiscard]] std::optional<cv::Rect> SeenRect(const ClusterShape& cluster,
                                               const CameraInfo& camera);

}  // namespace cvo::reports
