// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "experiments/calibration/stereo_rig.h"
#include "experiments/calibration/yaml_file.h"

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

// Two cameras of a Kalibr camchain: the right one must be the one after the left, as the chain
// states each camera by the one before. Rostopics that say left and right must say the same.
StereoRig ReadKalibrRig(const std::filesystem::path& path, const std::string& left,
                        const std::string& right);
// Two sensor.yaml of EuRoC's kind, with the pose of the camera in the body (T_BS).
StereoRig ReadSensorRig(const std::filesystem::path& left, const std::filesystem::path& right);

// Rotation and translation of 12 or 16 numbers, row by row. Calibrations are written with few
// digits, so the nearest rotation is taken.
RigidTransform ReadTransform(const YamlMap& map, const std::string& key);

}  // namespace cvo
