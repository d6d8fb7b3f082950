// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <array>
#include <filesystem>
#include <initializer_list>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/files/text_file.h"
#include "core/geometry/rigid_transform.h"
#include "core/geometry/stereo_camera.h"

namespace cvo {

// A file of lines "key: v v v" or "key v v v" (KITTI has both). No key may occur twice.
class CalibrationFile {
 public:
  explicit CalibrationFile(const std::filesystem::path& path);

  const std::filesystem::path& path() const { return file_.path(); }
  bool Has(const std::string& key) const { return line_of_key_.contains(key); }
  // Returns "<file>:<line>: <key>", for messages.
  std::string Where(const std::string& key) const;
  // Returns exactly `count` finite numbers. Throws Error if the key is missing or its line contains
  // anything else.
  std::vector<double> Numbers(const std::string& key, std::size_t count) const;
  Eigen::Matrix3d Rotation(const std::string& key) const;
  // Reads twelve numbers, a 3x4 matrix [R t] row by row.
  RigidTransform Transform(const std::string& key) const;
  // Returns the first of these keys that the file has; variants of the format name the same matrix
  // differently. Throws Error if it has none of them.
  std::string FirstOf(std::initializer_list<const char*> keys) const;

 private:
  TextFile file_;
  std::map<std::string, std::size_t> line_of_key_;
};

// The rectified cameras 0-3 of a KITTI vehicle. p_in_camera_k = p_in_camera_0 + (offset, 0, 0):
// this is how the devkit reads P_k, ignoring P_k(1,3) and P_k(2,3) (3 mm).
class CameraRig {
 public:
  // Reads those of the keys "<prefix>0" ... "<prefix>3" that the file has.
  CameraRig(const CalibrationFile& file, const std::string& prefix);

  // P_k(0,3) / fx, in metres. Throws Error if the file has no such camera.
  double Offset_m(int camera) const;
  // Throws Error unless the two cameras differ only by a positive baseline.
  StereoCamera Stereo(int left, int right, int width_px, int height_px) const;

 private:
  struct Projection {
    double fx, fy, cx, cy, offset_m;
  };
  const Projection& Get(int camera) const;

  std::filesystem::path path_;
  std::string prefix_;
  std::array<std::optional<Projection>, 4> projections_;
};

// Returns the rotation nearest to R. Throws Error(where, ...) unless R is a rotation to within 1e-3
// per entry of R R^T and not a reflection.
Eigen::Matrix3d CheckedRotation(const Eigen::Matrix3d& R, const std::string& where);

// Makes a transform from [R t], twelve numbers row by row. Throws Error(where, ...).
RigidTransform TransformFromRow(const std::vector<double>& row, const std::string& where);

}  // namespace cvo
