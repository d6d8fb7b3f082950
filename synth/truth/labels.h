// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "synth/truth/truth.h"

namespace cvo::synth {

// KITTI tracking labels of one frame, one line for each body with an amodal box: frame, track id
// (body id), type (category), truncation, occlusion (0: at least 0.8 of it visible, 1: 0.3, 2:
// some, 3: none), alpha, amodal box, height, width, length, middle of its box's bottom in the left
// camera's frame, heading about the camera's y axis. `row_frame`: number to write.
std::string FormatLabels(const World& world, const FrameTruth& truth, int row_frame);

// Text of a KITTI pose file's line: the upper 3 x 4 of the transform, shortest exact decimals.
std::string FormatKittiPose(const RigidTransform& world_from_camera);

// calib.txt of KITTI odometry; cameras 2 and 3 repeat 0 and 1.
std::string FormatKittiCalibration(const StereoCamera& rig);

// 7 as "000007", as KITTI names files.
std::string SixDigits(int number);

}  // namespace cvo::synth
