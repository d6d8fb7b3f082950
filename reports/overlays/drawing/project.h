// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core/types.hpp>
#include <optional>
#include <utility>
#include <vector>

#include "reports/overlays/drawing/overlay_frame.h"

namespace cvo::reports {

// a_from_b * p_in_b and its inverse, for poses as result files hold them.
Position Transform(const Pose& a_from_b, const Position& p_in_b);
Position TransformBack(const Pose& a_from_b, const Position& p_in_a);

// The camera of an image that was resized by `scale`.
CameraInfo ScaledCamera(const CameraInfo& camera, double scale);

using PixelSegment = std::pair<cv::Point2d, cv::Point2d>;

// Empty where the point is not in front of the camera.
[[nodiscard]] std::optional<cv::Point2d> ProjectPoint(const Position& p_in_camera,
                                                      const CameraInfo& camera);
// The part of a segment that is in front of the camera; empty where none is. Pixels may lie far
// outside the image.
[[nodiscard]] std::optional<PixelSegment> ProjectSegment(const Position& a, const Position& b,
                                                         const CameraInfo& camera);
// Of the twelve edges of a box, those parts that are in front of the camera.
std::vector<PixelSegment> ProjectEdges(const std::array<Position, 8>& corners,
                                       const CameraInfo& camera);
// The part of a segment within the image or at most `margin_px` beside it.
[[nodiscard]] std::optional<PixelSegment> ClipSegment(const PixelSegment& segment, cv::Size image,
                                                      double margin_px);

}  // namespace cvo::reports
