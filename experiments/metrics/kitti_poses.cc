// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/metrics/kitti_poses.h"

#include <Eigen/LU>

#include "core/base/error.h"
#include "core/files/number.h"
#include "core/files/text_file.h"

namespace cvo {
namespace {

constexpr std::size_t kRowNumbers = 12;

}  // namespace

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
  Require(row.size() == kRowNumbers, "TransformFromRow: needs twelve numbers");
  Eigen::Matrix3d R;
  R << row[0], row[1], row[2], row[4], row[5], row[6], row[8], row[9], row[10];
  return {CheckedRotation(R, where), Eigen::Vector3d(row[3], row[7], row[11])};
}

std::vector<RigidTransform> ReadKittiPoses(const std::filesystem::path& path) {
  const TextFile file(path);
  std::vector<RigidTransform> poses;
  for (std::size_t i = 0; i < file.size(); ++i) {
    const TextRow row(file, i);
    row.ExpectColumns(kRowNumbers, "a pose [R t] row by row");
    std::vector<double> numbers;
    for (std::size_t k = 0; k < kRowNumbers; ++k) numbers.push_back(row.Number(k));
    poses.push_back(TransformFromRow(numbers, file.Where(i)));
  }
  return poses;
}

std::string FormatKittiPoses(const std::vector<RigidTransform>& world_from_camera) {
  std::string text;
  for (const RigidTransform& pose : world_from_camera) {
    const Eigen::Matrix4d matrix = pose.Matrix();
    for (int i = 0; i < static_cast<int>(kRowNumbers); ++i) {
      text += FormatDouble(matrix(i / 4, i % 4));
      text += i + 1 < static_cast<int>(kRowNumbers) ? ' ' : '\n';
    }
  }
  return text;
}

void WriteKittiPoses(const std::filesystem::path& path,
                     const std::vector<RigidTransform>& world_from_camera) {
  WriteFileBytes(path, FormatKittiPoses(world_from_camera));
}

}  // namespace cvo
