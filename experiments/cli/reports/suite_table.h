// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

#include "experiments/cli/reports/table_format.h"

namespace cvo {

// The estimator's options at their defaults, as nested JSON.
std::string DefaultOptions();

// Makes the table of the folder that a suite is run to and prints it; in a terminal also writes
// table.json and table.md there, unless rows are compared with another one (MakeTable) than the
// suite says. 0: all that can run has run; 1: some jobs failed or did not run
// yet. Throws Error without a plan.
int OutputSuiteTable(const std::filesystem::path& folder, const TableFormat& format,
                     const std::string& compared_with = "");

}  // namespace cvo
