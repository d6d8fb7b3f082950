// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "synth/render/renderer.h"

namespace cvo::synth {

// Half the side of the cv::cornerSubPix window, px: a window contains only one corner.
inline constexpr int kCornerWindow_px = 7;

// A checkerboard whose corners measure how exactly the renders follow the projection of a rig.
struct CalibrationTarget {
  World world;                             // its frame is the board's; the board is at z = 0
  std::vector<Eigen::Vector3d> corners_m;  // inner corners, in the board's frame
  std::vector<View> views;                 // board tilted and rotated, all corners in both images
};

CalibrationTarget MakeCalibrationTarget(const StereoCamera& rig);

}  // namespace cvo::synth
