// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "experiments/calibration/stereo_rig.h"
#include "experiments/calibration/yaml_file.h"

namespace cvo {

// Reads a stereo calibration. The keys tell the format:
// - our own, YAML or JSON. For a rectified pair fx, fy, cx, cy, baseline_m; otherwise `left` and
//   `right`, each with fx, fy, cx, cy, lens (none, plumb_bob, equidistant) and coefficients, and
//   right_from_left (12 numbers of [R t], metres). Optionally width_px and height_px;
// - OpenCV's stereo calibration: K1 D1 K2 D2 R T, also M1 ... or cameraMatrix1, distCoeffs1 ...;
// - Kalibr's camchain: cam0, cam1;
// - KITTI's calib.txt: P0, P1 (else P2, P3), or P_rect_00, P_rect_01.
// Throws Error with the file, what was found and what was expected.
StereoRig ReadStereoRig(const std::filesystem::path& path);

// Reads two cameras of a Kalibr camchain. The right one must be the next one after the left in the
// chain, which states the pose of each camera relative to the previous one. Rostopics that contain
// "left" or "right" must agree with the order.
StereoRig ReadKalibrRig(const std::filesystem::path& path, const std::string& left,
                        const std::string& right);
// Reads two sensor.yaml files in EuRoC's format, each with the pose of its camera in the body frame
// (T_BS).
StereoRig ReadSensorRig(const std::filesystem::path& left, const std::filesystem::path& right);

// Reads a rigid transform from 12 or 16 numbers, row by row. Takes the nearest rotation, because
// calibrations are written with few digits.
RigidTransform ReadTransform(const YamlMap& map, const std::string& key);

}  // namespace cvo
