// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "reports/gate/baseline.h"

namespace cvo::reports {

// From a folder that a suite was run to. `gate_seeds`: how many of its seeds, the lowest first, a
// checked run must have (0: all); the rest tell how far seeds are apart. Throws Error naming what
// is in the way: a job that is not done, contracts that differ, fewer than two seeds, no metric.
Baseline MakeBaseline(const std::filesystem::path& folder, std::size_t gate_seeds = 0);

}  // namespace cvo::reports
