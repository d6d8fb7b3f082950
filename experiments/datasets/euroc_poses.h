// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "experiments/metrics/trajectory.h"

namespace cvo {

// Reads the poses of the body (world_from_body) from a EuRoC file. Throws Error.
Trajectory ReadEurocPoses(const std::filesystem::path& path);

}  // namespace cvo
