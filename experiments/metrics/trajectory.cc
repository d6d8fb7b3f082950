// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/metrics/trajectory.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include "core/base/error.h"
#include "core/files/text/number.h"
#include "core/files/text_file.h"
#include "experiments/calibration/kitti_calibration.h"

namespace cvo {
namespace {

constexpr std::size_t kRowNumbers = 12;  // numbers of a KITTI pose

RigidTransform ReadPose(const TextRow& row) {
  const Eigen::Vector3d translation(row.Number(1), row.Number(2), row.Number(3));
  const Eigen::Quaterniond q(row.Number(7), row.Number(4), row.Number(5), row.Number(6));
  constexpr double kTolerance = 1e-3;
  if (!(std::abs(q.norm() - 1.0) <= kTolerance)) {
    row.Fail(StrCat("a quaternion of length ", q.norm()),
             StrCat("length 1 to within ", kTolerance));
  }
  RigidTransform pose(q, translation);
  // Normalising a quaternion again that was written normalised would change its last bit.
  if (std::abs(q.squaredNorm() - 1.0) <= 4.0 * std::numeric_limits<double>::epsilon()) {
    std::copy(q.coeffs().data(), q.coeffs().data() + 4, pose.data());
  }
  return pose;
}

// Counts the words before the first one that starts a comment.
int CountColumns(const std::string& line) {
  std::istringstream words(line);
  std::string word;
  int columns = 0;
  while (words >> word && !word.starts_with('#')) ++columns;
  return columns;
}

}  // namespace

std::optional<RigidTransform> InterpolatePose(const Trajectory& trajectory, std::int64_t time_ns) {
  const auto after = std::lower_bound(
      trajectory.begin(), trajectory.end(), time_ns,
      [](const TimedPose& pose, std::int64_t time) { return pose.timestamp_ns < time; });
  if (after == trajectory.end()) return std::nullopt;
  if (after->timestamp_ns == time_ns) return after->world_from_camera;
  if (after == trajectory.begin()) return std::nullopt;
  const TimedPose& a = *(after - 1);
  const TimedPose& b = *after;
  const double s = static_cast<double>(time_ns - a.timestamp_ns) /
                   static_cast<double>(b.timestamp_ns - a.timestamp_ns);
  return RigidTransform(
      a.world_from_camera.rotation().slerp(s, b.world_from_camera.rotation()),
      (1.0 - s) * a.world_from_camera.translation() + s * b.world_from_camera.translation());
}

Trajectory ReadTumTrajectory(const std::filesystem::path& path) {
  const TextFile file(path);
  Trajectory trajectory;
  for (std::size_t i = 0; i < file.size(); ++i) {
    const TextRow row(file, i);
    if (row.size() == 0 || row.Text(0).starts_with('#')) continue;
    row.ExpectColumns(8, "time tx ty tz qx qy qz qw");
    const std::int64_t time_ns = row.SecondsNs(0);
    if (!trajectory.empty() && time_ns <= trajectory.back().timestamp_ns) {
      row.Fail("time " + Quoted(row.Text(0)),
               StrCat("one after ", FormatSecondsNs(trajectory.back().timestamp_ns)));
    }
    trajectory.push_back({time_ns, ReadPose(row)});
  }
  return trajectory;
}

std::string FormatTumTrajectory(const Trajectory& trajectory) {
  std::string text;
  for (const TimedPose& pose : trajectory) {
    text += FormatSecondsNs(pose.timestamp_ns);
    const double* block = pose.world_from_camera.data();
    for (const int i : {4, 5, 6, 0, 1, 2, 3}) {
      text += ' ';
      text += FormatDouble(block[i]);
    }
    text += '\n';
  }
  return text;
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

std::string DetectPoseFormat(const std::filesystem::path& path) {
  const TextFile file(path);
  for (std::size_t i = 0; i < file.size(); ++i) {
    const int columns = CountColumns(file.line(i));
    if (columns == 0) continue;
    if (columns == 8) return "tum";
    if (columns == 12) return "kitti";
    ThrowError(file.Where(i), StrCat(columns, " columns"),
               "8 (TUM: time tx ty tz qx qy qz qw) or 12 (KITTI: rows of [R t])");
  }
  ThrowError(path.string(), "no pose", "a TUM or KITTI trajectory");
}

std::string WhereTumPose(const std::filesystem::path& path, std::size_t index) {
  const TextFile file(path);
  for (std::size_t i = 0; i < file.size(); ++i) {
    if (CountColumns(file.line(i)) == 0) continue;
    if (index == 0) return file.Where(i);
    --index;
  }
  throw Error(path.string() + ": no such pose");
}

}  // namespace cvo
