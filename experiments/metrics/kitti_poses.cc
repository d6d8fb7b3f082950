// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/metrics/kitti_poses.h"

#include "core/base/error.h"
#include "core/files/number.h"
#include "core/files/text_file.h"
#include "experiments/calibration/pose_row.h"

namespace cvo {
namespace {

constexpr std::size_t kRowNumbers = 12;

}  // namespace

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
