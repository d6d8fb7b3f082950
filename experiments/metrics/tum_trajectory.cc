// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/metrics/tum_trajectory.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/error.h"
#include "core/files/number.h"
#include "core/files/text_file.h"

namespace cvo {
namespace {

RigidTransform ReadPose(const TextRow& row) {
  const Eigen::Vector3d translation(row.Number(1), row.Number(2), row.Number(3));
  const Eigen::Quaterniond q(row.Number(7), row.Number(4), row.Number(5), row.Number(6));
  constexpr double kTolerance = 1e-3;
  if (!(std::abs(q.norm() - 1.0) <= kTolerance)) {
    row.Fail(StrCat("a quaternion of length ", q.norm()),
             StrCat("length 1 to within ", kTolerance));
  }
  RigidTransform pose(q, translation);
  // Normalising again would move the last bit of a quaternion that was written normalised.
  if (std::abs(q.squaredNorm() - 1.0) <= 4.0 * std::numeric_limits<double>::epsilon()) {
    std::copy(q.coeffs().data(), q.coeffs().data() + 4, pose.data());
  }
  return pose;
}

}  // namespace

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

void WriteTumTrajectory(const std::filesystem::path& path, const Trajectory& trajectory) {
  WriteFileBytes(path, FormatTumTrajectory(trajectory));
}

}  // namespace cvo
