// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core/types.hpp>
#include <vector>

#include "core/features/options.h"
#include "core/geometry/stereo_camera.h"

namespace cvo {

// A part of an image that should have at least so many corners, as far as there are any.
struct CornerRegion {
  cv::Rect2d box;
  int corners = 0;
};

// Around boxes in the left image where bodies may be, orb.box_features corners in each.
std::vector<CornerRegion> LeftRegions(const std::vector<cv::Rect2d>& boxes, const OrbOptions& orb);
// Where what is in these boxes may be seen in the right image, with as many corners per pixel as on
// the left, times stereo.right_features: the partners are among them.
std::vector<CornerRegion> RightRegions(const std::vector<cv::Rect2d>& boxes, const OrbOptions& orb,
                                       const StereoMatchOptions& stereo,
                                       const StereoCamera& camera);

}  // namespace cvo
