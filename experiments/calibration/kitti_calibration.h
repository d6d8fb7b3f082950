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

// Lines "key: v v v" or "key v v v" (both occur in KITTI); each key once.
class CalibrationFile {
 public:
  explicit CalibrationFile(const std::filesystem::path& path);

  const std::filesystem::path& path() const { return file_.path(); }
  bool Has(const std::string& key) const { return line_of_key_.contains(key); }
  // "<file>:<line>: <key>" for messages.
  std::string Where(const std::string& key) const;
  // Exactly `count` finite numbers. Throws Error where the key is absent or its line is not that.
  std::vector<double> Numbers(const std::string& key, std::size_t count) const;
  Eigen::Matrix3d Rotation(const std::string& key) const;
  // Twelve numbers of a 3x4 matrix [R t], row by row.
  RigidTransform Transform(const std::string& key) const;
  // The first of these keys that the file has: dialects name the same matrix differently. Throws
  // Error where it has none.
  std::string FirstOf(std::initializer_list<const char*> keys) const;

 private:
  TextFile file_;
  std::map<std::string, std::size_t> line_of_key_;
};

// The rectified cameras 0-3 of a KITTI vehicle. A point seen from camera k is the point seen from
// camera 0 moved by (offset, 0, 0): the devkit's reading of P_k, which leaves out P_k(1,3) and
// P_k(2,3) (3 mm).
class CameraRig {
 public:
  // Keys "<prefix>0" ... "<prefix>3", as many as the file has.
  CameraRig(const CalibrationFile& file, const std::string& prefix);

  // P_k(0,3) / fx, metres. Throws Error where the file has no such camera.
  double Offset_m(int camera) const;
  // Throws Error where the two cameras differ in more than a positive baseline.
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

// The rotation nearest to R, which must be one to within 1e-3 per entry of R R^T and not a
// reflection. Throws Error(where, ...).
Eigen::Matrix3d CheckedRotation(const Eigen::Matrix3d& R, const std::string& where);

// [R t] row by row, twelve numbers. Throws Error(where, ...).
RigidTransform TransformFromRow(const std::vector<double>& row, const std::string& where);

}  // namespace cvo
