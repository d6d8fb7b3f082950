// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "synth/truth/truth.h"

namespace cvo::synth {

// Formats the KITTI tracking labels of one frame, one line for each body with an amodal box: frame,
// track id (body id), type (category), truncation, occlusion (0: at least 0.8 visible, 1: at least
// 0.3, 2: less, 3: nothing), alpha, amodal box, height, width, length, bottom centre of its 3D box
// in the left camera's frame, heading about the camera's y axis. `row_frame` is the frame number to
// write.
std::string FormatLabels(const World& world, const FrameTruth& truth, int row_frame);

// Formats a line of a KITTI pose file: the upper 3x4 of the transform, in the shortest decimals
// that read back exactly.
std::string FormatKittiPose(const RigidTransform& world_from_camera);

// Formats calib.txt of KITTI odometry; cameras 2 and 3 repeat 0 and 1.
std::string FormatKittiCalibration(const StereoCamera& rig);

// Formats 7 as "000007", as in KITTI's file names.
std::string SixDigits(int number);

}  // namespace cvo::synth
