// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "reports/results/suite_runs.h"

namespace cvo::reports {

// In what the runs of two folders differ besides their results, in one line: variants that only one
// has, options of those that both have, builds of the program.
std::string WhatDiffers(const std::vector<SuiteRun>& before, const std::vector<SuiteRun>& after);

}  // namespace cvo::reports
