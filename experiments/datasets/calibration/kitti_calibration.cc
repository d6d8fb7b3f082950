// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/datasets/calibration/kitti_calibration.h"

#include <Eigen/LU>
#include <cmath>

#include "core/base/error.h"

namespace cvo {

CalibrationFile::CalibrationFile(const std::filesystem::path& path) : file_(path) {
  for (std::size_t i = 0; i < file_.size(); ++i) {
    const TextRow row(file_, i);
    if (row.size() == 0) continue;
    std::string key(row.Text(0));
    if (key.ends_with(':')) key.pop_back();
    if (!line_of_key_.emplace(key, i).second) {
      row.Fail(Quoted(key) + " a second time", "each name once");
    }
  }
}

std::string CalibrationFile::Where(const std::string& key) const {
  const auto line = line_of_key_.find(key);
  return line == line_of_key_.end() ? path().string()
                                    : StrCat(file_.Where(line->second), ": ", key);
}

std::vector<double> CalibrationFile::Numbers(const std::string& key, std::size_t count) const {
  const auto line = line_of_key_.find(key);
  if (line == line_of_key_.end()) {
    ThrowError(path().string(), StrCat("no ", key), StrCat(key, " with ", count, " numbers"));
  }
  const TextRow row(file_, line->second);
  row.ExpectColumns(count + 1, StrCat(key, " and ", count, " numbers"));
  std::vector<double> numbers;
  for (std::size_t i = 1; i <= count; ++i) numbers.push_back(row.Number(i));
  return numbers;
}

Eigen::Matrix3d CalibrationFile::Rotation(const std::string& key) const {
  const std::vector<double> v = Numbers(key, 9);
  Eigen::Matrix3d R;
  R << v[0], v[1], v[2], v[3], v[4], v[5], v[6], v[7], v[8];
  return CheckedRotation(R, Where(key));
}

RigidTransform CalibrationFile::Transform(const std::string& key) const {
  return TransformFromRow(Numbers(key, 12), Where(key));
}

std::string CalibrationFile::FirstOf(std::initializer_list<const char*> keys) const {
  std::string names;
  for (const char* key : keys) {
    if (Has(key)) return key;
    names += (names.empty() ? "" : " or ") + std::string(key);
  }
  ThrowError(path().string(), "none of them", names);
}

CameraRig::CameraRig(const CalibrationFile& file, const std::string& prefix)
    : path_(file.path()), prefix_(prefix) {
  for (std::size_t camera = 0; camera < projections_.size(); ++camera) {
    const std::string key = prefix + std::to_string(camera);
    if (!file.Has(key)) continue;
    const std::vector<double> P = file.Numbers(key, 12);
    const double fx = P[0], fy = P[5];
    if (!(fx > 0.0 && fy > 0.0)) {
      ThrowError(file.Where(key), StrCat("focal lengths ", fx, " and ", fy), "positive ones");
    }
    if (P[1] != 0.0 || P[4] != 0.0 || P[8] != 0.0 || P[9] != 0.0 || P[10] != 1.0) {
      ThrowError(file.Where(key), "a matrix of another form",
                 "[fx 0 cx a; 0 fy cy b; 0 0 1 c], a rectified camera");
    }
    projections_[camera] = Projection{fx, fy, P[2], P[6], P[3] / fx};
  }
}

const CameraRig::Projection& CameraRig::Get(int camera) const {
  const auto index = static_cast<std::size_t>(camera);
  if (camera < 0 || index >= projections_.size() || !projections_[index]) {
    ThrowError(path_.string(), StrCat("no ", prefix_, camera), "one projection per camera used");
  }
  return *projections_[index];
}

double CameraRig::Offset_m(int camera) const { return Get(camera).offset_m; }

StereoCamera CameraRig::Stereo(int left, int right, int width_px, int height_px) const {
  const Projection& l = Get(left);
  const Projection& r = Get(right);
  const std::string where = StrCat(path_.string(), ": ", prefix_, left, " and ", prefix_, right);
  constexpr double kSame_px = 1e-3;
  const auto same = [](double a, double b) { return std::abs(a - b) <= kSame_px; };
  if (!same(l.fx, r.fx) || !same(l.fy, r.fy) || !same(l.cx, r.cx) || !same(l.cy, r.cy)) {
    ThrowError(where, "different focal lengths or centres", "equal ones, as after rectification");
  }
  const double baseline_m = l.offset_m - r.offset_m;
  if (!(baseline_m > 0.0)) {
    ThrowError(where, StrCat("a baseline of ", baseline_m, " m"), "a positive one");
  }
  return {l.fx, l.fy, l.cx, l.cy, baseline_m, width_px, height_px};
}

Eigen::Matrix3d CheckedRotation(const Eigen::Matrix3d& R, const std::string& where) {
  constexpr double kTolerance = 1e-3;
  const double defect = (R * R.transpose() - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff();
  if (!(defect <= kTolerance)) {
    ThrowError(where, StrCat("a matrix whose R R^T is off the identity by ", defect),
               StrCat("a rotation, off by at most ", kTolerance));
  }
  if (R.determinant() < 0.0) ThrowError(where, "a reflection", "a rotation");
  return NearestRotation(R);
}

RigidTransform TransformFromRow(const std::vector<double>& row, const std::string& where) {
  Require(row.size() == 12, "TransformFromRow: needs twelve numbers");
  Eigen::Matrix3d R;
  R << row[0], row[1], row[2], row[4], row[5], row[6], row[8], row[9], row[10];
  return {CheckedRotation(R, where), Eigen::Vector3d(row[3], row[7], row[11])};
}

}  // namespace cvo
