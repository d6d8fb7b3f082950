// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

namespace cvo {

// "tum" or "kitti", by the number of columns in the first line that is no comment. Throws Error
// with file and line.
std::string DetectPoseFormat(const std::filesystem::path& path);

// "<path>:<line>" of a pose, counted from 0, of a file that ReadTumTrajectory reads.
std::string WhereTumPose(const std::filesystem::path& path, std::size_t index);

}  // namespace cvo
