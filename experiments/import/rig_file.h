// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "experiments/import/stereo_rig.h"

namespace cvo {

// A stereo calibration, whose format is known by its keys:
// - ours, YAML or JSON: of a rectified pair fx, fy, cx, cy, baseline_m; else `left` and `right`
// with
//   fx, fy, cx, cy, lens (none, plumb_bob, equidistant), coefficients, and right_from_left (12
//   numbers of [R t], metres); width_px and height_px may be stated;
// - OpenCV's stereo calibration: K1 D1 K2 D2 R T, also M1 ... or cameraMatrix1, distCoeffs1 ...;
// - Kalibr's camchain: cam0, cam1;
// - KITTI's calib.txt: P0, P1 (else P2, P3), or P_rect_00, P_rect_01.
// Throws Error with the file, what was found and what was expected.
StereoRig ReadStereoRig(const std::filesystem::path& path);

}  // namespace cvo
