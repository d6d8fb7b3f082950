// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>
#include <opencv2/core/types.hpp>
#include <span>
#include <vector>

#include "core/features/options.h"
#include "core/features/orb/corner_score.h"
#include "core/geometry/stereo_camera.h"

namespace cvo {

// A region of an image in which a reserve of corners is kept: at least `corners` of them, if the
// region has that many.
struct CornerRegion {
  cv::Rect2d box;
  int corners = 0;
};

// Number of frames for which a box keeps a reserve of corners around it: detectors occasionally
// miss bodies (METHOD.md 2.1).
inline constexpr int kReserveFrames = 3;

// Boxes in the left image that may contain bodies, for consecutive frames, the current frame last.
using RecentBoxes = std::span<const std::vector<cv::Rect2d>>;

// Returns the regions of the left image: the boxes of the current frame, with orb.box_features
// corners in each, and those of the last kReserveFrames frames unless a newer region contains
// their centre. Older boxes are grown by how far their bodies may have moved.
std::vector<CornerRegion> LeftRegions(RecentBoxes boxes, const OrbOptions& orb);
// Returns the regions of the right image that may show the content of these left regions. They get
// stereo.right_features times as many corners per pixel as on the left, so that the stereo partners
// are among them.
std::vector<CornerRegion> RightRegions(std::vector<CornerRegion> regions,
                                       const StereoMatchOptions& stereo,
                                       const StereoCamera& camera);

// Refines a corner to sub-pixel accuracy. Returns the maximum of a paraboloid fitted to the 3 x 3
// scores around the pixel (x, y), which has the largest score, relative to that pixel. Zero if the
// paraboloid has no maximum within 1 px.
Eigen::Vector2d RefineCorner(const cv::Mat& scores, int x, int y);

// Selects at most `quota` corners that are evenly spread, and returns them in reading order. The
// strongest are taken first, and none is nearer to another than a distance chosen so that about
// `quota` remain (adaptive non-maximal suppression, Brown et al. 2005). Unlike a grid or a
// quadtree, the selection moves with the image content, so that the same corners are selected in
// the other image and in the next one.
std::vector<Corner> SelectEvenly(const std::vector<Corner>& corners, int quota);

}  // namespace cvo
