// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

#include "experiments/metrics/trajectory.h"

namespace cvo {

// TUM trajectory files: "time tx ty tz qx qy qz qw" per line, time in seconds, comments after #.
// Reading is strict (finite numbers, unit quaternions to within 1e-3, increasing time) and throws
// Error with file and line. Written files read back as the same trajectory, times exact to 1 ns.
Trajectory ReadTumTrajectory(const std::filesystem::path& path);
std::string FormatTumTrajectory(const Trajectory& trajectory);
void WriteTumTrajectory(const std::filesystem::path& path, const Trajectory& trajectory);

}  // namespace cvo
