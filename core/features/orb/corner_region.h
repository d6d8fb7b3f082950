// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core/types.hpp>
#include <span>
#include <vector>

#include "core/features/options.h"
#include "core/geometry/stereo_camera.h"

namespace cvo {

// A part of an image that has a reserve of corners, at least so many of them as far as there are
// any.
struct CornerRegion {
  cv::Rect2d box;
  int corners = 0;
};

// Boxes in the left image where bodies may be, of frames in a row, the present one last.
using RecentBoxes = std::span<const std::vector<cv::Rect2d>>;

// Boxes of the present frame, with orb.box_features corners in each, and those of the last
// orb.reserve_frames in which no newer one has its centre, grown by how far their bodies may have
// moved.
std::vector<CornerRegion> LeftRegions(RecentBoxes boxes, const OrbOptions& orb);
// Where what is in these regions may be seen in the right image, with as many corners per pixel as
// on the left, times stereo.right_features: the partners are among them.
std::vector<CornerRegion> RightRegions(std::vector<CornerRegion> regions,
                                       const StereoMatchOptions& stereo,
                                       const StereoCamera& camera);

}  // namespace cvo
