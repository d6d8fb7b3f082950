// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "experiments/metrics/trajectory.h"

namespace cvo {

// A file of EuRoC with poses of the body. Throws Error.
Trajectory ReadEurocPoses(const std::filesystem::path& path);

}  // namespace cvo
