// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "reports/results/suite_runs.h"

namespace cvo::reports {

// Describes in one line how the runs of two folders differ apart from their results: variants that
// only one folder has, options of the variants that both have, builds of the program.
std::string WhatDiffers(const std::vector<SuiteRun>& before, const std::vector<SuiteRun>& after);

}  // namespace cvo::reports
