// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "synth/render/renderer.h"

namespace cvo::synth {

// Half the side of the window for cv::cornerSubPix in which no second corner is, px.
inline constexpr int kCornerWindow_px = 7;

// A checkerboard whose corners tell how exactly a rig's renders follow its projection.
struct CalibrationTarget {
  World world;                             // the board's frame is the world; the board is at z = 0
  std::vector<Eigen::Vector3d> corners_m;  // inner corners, in the board's frame
  std::vector<View> views;                 // tilted and turned, all corners in both images
};

CalibrationTarget MakeCalibrationTarget(const StereoCamera& rig);

}  // namespace cvo::synth
