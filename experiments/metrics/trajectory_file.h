// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/geometry/rigid_transform.h"

namespace cvo {

struct TimedPose {
  std::int64_t timestamp_ns = 0;
  RigidTransform world_from_camera;
};

// Poses with strictly increasing timestamps.
using Trajectory = std::vector<TimedPose>;

// A trajectory as a file tells it.
struct TrajectoryFile {
  Trajectory poses;
  std::vector<std::size_t> lines;     // of the poses, from 1
  std::vector<std::size_t> left_out;  // lines with NaN or infinity
  // False if quaternions are missing, all zero or all the same: the file tells positions alone, and
  // the rotations of the poses mean nothing.
  bool has_rotations = true;
};

// Reads one pose per line: time, position, quaternion; or time and position alone. Columns are
// divided by blanks (TUM: x y z w), commas or semicolons, in the order of the header's names or,
// without one, with commas that of EuRoC and VINS-Fusion (w x y z); a comma at the end and further
// columns are then ignored. Times are in s, ms, us or ns
// (TimeUnitOf). Lines of comments start with #. Quaternions are normalised if their length is
// within 0.05 of 1. Throws Error with file and line.
TrajectoryFile ReadTrajectory(const std::filesystem::path& path);
// Written files read back as the same trajectory, with times exact to 1 ns.
std::string FormatTumTrajectory(const Trajectory& trajectory);

// KITTI pose files: world_from_camera of frame i in line i, without timestamps. Reading is strict
// and throws Error with file and line. Written numbers read back as the same doubles.
std::vector<RigidTransform> ReadKittiPoses(const std::filesystem::path& path);
std::string FormatKittiPoses(const std::vector<RigidTransform>& world_from_camera);

// Whether a file is KITTI's: its first line that is no comment has 12 columns divided by blanks.
bool IsKittiPoseFile(const std::filesystem::path& path);

}  // namespace cvo
