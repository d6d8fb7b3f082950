// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

#include "experiments/datasets/calibration/stereo_rig.h"
#include "experiments/datasets/calibration/yaml_map.h"

namespace cvo {

// Reads a stereo calibration. The keys tell the format:
// - our own, YAML or JSON. For a rectified pair fx, fy, cx, cy, baseline_m; otherwise `left` and
//   `right`, each with fx, fy, cx, cy, lens (none, plumb_bob, equidistant) and coefficients, and
//   right_from_left (12 numbers of [R t], metres). Optionally width_px and height_px;
// - OpenCV's stereo calibration: K1 D1 K2 D2 R T, also M1 ... or cameraMatrix1, distCoeffs1 ...;
//   R and T may be in a second file;
// - Kalibr's camchain: cam0, cam1, with T_cn_cnm1, T_cam_imu or, of OpenVINS, T_imu_cam;
// - ROS's camera_info: one file of the left, a second one of the right camera;
// - settings of ORB-SLAM2 and ORB-SLAM3: Camera.fx, Camera.bf or LEFT.K ...; Camera1.fx and
//   Camera2.fx;
// - KITTI's calib.txt: P0, P1 (else P2, P3), or P_rect_00, P_rect_01.
// Throws Error with the file, what was found and what was expected.
StereoRig ReadStereoRig(const std::filesystem::path& path,
                        const std::filesystem::path& second = {});

// Reads two cameras of a Kalibr camchain. The right one must be the next one after the left in the
// chain, which states the pose of each camera relative to the previous one.
StereoRig ReadKalibrRig(const std::filesystem::path& path, const std::string& left,
                        const std::string& right);
// Reads two sensor.yaml files in EuRoC's format, each with the pose of its camera in the body frame
// (T_BS).
StereoRig ReadSensorRig(const std::filesystem::path& left, const std::filesystem::path& right);

}  // namespace cvo
