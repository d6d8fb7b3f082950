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

// Poses with strictly increasing timestamps.
using Trajectory = std::vector<TimedPose>;

// Interpolates the pose at a time: linear in position, along the shortest arc in rotation. Empty
// outside the time range of the trajectory.
[[nodiscard]] std::optional<RigidTransform> InterpolatePose(const Trajectory& trajectory,
                                                            std::int64_t time_ns);

// TUM trajectory files: "time tx ty tz qx qy qz qw" per line, time in seconds, comments after #.
// Reading is strict (finite numbers, unit quaternions to within 1e-3, increasing times) and throws
// Error with file and line. Written files read back as the same trajectory, with times exact to 1
// ns.
Trajectory ReadTumTrajectory(const std::filesystem::path& path);
std::string FormatTumTrajectory(const Trajectory& trajectory);

// KITTI pose files: world_from_camera of frame i in line i, without timestamps. Reading is strict
// and throws Error with file and line. Written numbers read back as the same doubles.
std::vector<RigidTransform> ReadKittiPoses(const std::filesystem::path& path);
std::string FormatKittiPoses(const std::vector<RigidTransform>& world_from_camera);

// Returns "tum" or "kitti", from the number of columns in the first line that is not a comment.
// Throws Error with file and line.
std::string DetectPoseFormat(const std::filesystem::path& path);

// Returns "<path>:<line>" of the pose with this index (from 0) in a file that ReadTumTrajectory
// reads.
std::string WhereTumPose(const std::filesystem::path& path, std::size_t index);

}  // namespace cvo
