// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/geometry/rigid_transform.h"

namespace cvo {

struct TimedPose {
  std::int64_t timestamp_ns = 0;
  RigidTransform world_from_camera;
};

// Strictly increasing in time.
using Trajectory = std::vector<TimedPose>;

// The pose at a time: position linear, rotation on the shortest arc. Empty outside the range of
// times.
[[nodiscard]] std::optional<RigidTransform> InterpolatePose(const Trajectory& trajectory,
                                                            std::int64_t time_ns);

// TUM trajectory files: "time tx ty tz qx qy qz qw" per line, time in seconds, comments after #.
// Reading is strict (finite numbers, unit quaternions to within 1e-3, increasing time) and throws
// Error with file and line. Written files read back as the same trajectory, times exact to 1 ns.
Trajectory ReadTumTrajectory(const std::filesystem::path& path);
std::string FormatTumTrajectory(const Trajectory& trajectory);

// KITTI pose files: world_from_camera of frame i in line i, without timestamps. Reading is strict
// and throws Error with file and line; written numbers read back as the same doubles.
std::vector<RigidTransform> ReadKittiPoses(const std::filesystem::path& path);
std::string FormatKittiPoses(const std::vector<RigidTransform>& world_from_camera);

// "tum" or "kitti", by the number of columns in the first line that is no comment. Throws Error
// with file and line.
std::string DetectPoseFormat(const std::filesystem::path& path);

// "<path>:<line>" of a pose, counted from 0, of a file that ReadTumTrajectory reads.
std::string WhereTumPose(const std::filesystem::path& path, std::size_t index);

}  // namespace cvo
