// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "reports/gate/baseline.h"

namespace cvo::reports {

// Makes a baseline from a folder that a suite was run to. `gate_seeds` is how many of its seeds,
// the lowest first, must be among checked runs (0: all); the rest only serve to estimate the spread
// between seeds. Throws Error naming the obstacle: a job that is not done, contracts that differ,
// fewer than two seeds, or no metric.
Baseline MakeBaseline(const std::filesystem::path& folder, std::size_t gate_seeds = 0);

}  // namespace cvo::reports
