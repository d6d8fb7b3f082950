// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core/types.hpp>
#include <optional>
#include <utility>
#include <vector>

#include "reports/overlays/drawing/overlay_frame.h"

namespace cvo::reports {

// Apply a pose (a_from_b * p_in_b) and its inverse to a point, for poses as stored in result files.
Position Transform(const Pose& a_from_b, const Position& p_in_b);
Position TransformBack(const Pose& a_from_b, const Position& p_in_a);

// The camera of an image that was resized by `scale`.
CameraInfo ScaledCamera(const CameraInfo& camera, double scale);

using PixelSegment = std::pair<cv::Point2d, cv::Point2d>;

// Projects a point to pixels. Empty if it is not in front of the camera.
[[nodiscard]] std::optional<cv::Point2d> ProjectPoint(const Position& p_in_camera,
                                                      const CameraInfo& camera);
// Projects the part of a segment that is in front of the camera. Empty if there is none. Pixels may
// lie far outside the image.
[[nodiscard]] std::optional<PixelSegment> ProjectSegment(const Position& a, const Position& b,
                                                         const CameraInfo& camera);
// Projects those parts of the twelve edges of a box that are in front of the camera.
std::vector<PixelSegment> ProjectEdges(const std::array<Position, 8>& corners,
                                       const CameraInfo& camera);
// Clips a segment to the image extended by `margin_px` on all sides. Empty if nothing is left.
[[nodiscard]] std::optional<PixelSegment> ClipSegment(const PixelSegment& segment, cv::Size image,
                                                      double margin_px);

}  // namespace cvo::reports
