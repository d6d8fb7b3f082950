// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <yaml-cpp/yaml.h>

#include <filesystem>
#include <string>
#include <vector>

#include "experiments/datasets/calibration/stereo_rig.h"

namespace cvo {

// A calibration file in YAML (or JSON). A value that is missing or has the wrong type is an Error
// that names the file and the key.
class YamlMap {
 public:
  // Throws Error unless the file is a single map. Skips the first line of OpenCV's files, which is
  // not valid YAML.
  static YamlMap Read(const std::filesystem::path& path);

  bool Has(const std::string& key) const { return static_cast<bool>(node_[key]); }
  YamlMap Map(const std::string& key) const;
  double Number(const std::string& key) const;  // must be finite
  std::string Text(const std::string& key) const;
  // Returns all numbers of a list, of a list of lists row by row, or of a matrix as OpenCV writes
  // it.
  std::vector<double> Numbers(const std::string& key) const;
  std::vector<double> Numbers(const std::string& key, std::size_t count) const;
  // Throws Error for a key of the map that is not among `keys`.
  void AllowOnly(const std::vector<std::string>& keys) const;
  [[noreturn]] void Fail(const std::string& key, const std::string& found,
                         const std::string& expected) const;

 private:
  YamlMap(std::string where, YAML::Node node) : where_(std::move(where)), node_(std::move(node)) {}
  YAML::Node Get(const std::string& key) const;

  std::string where_;
  YAML::Node node_;
};

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
