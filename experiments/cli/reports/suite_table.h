// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

#include "experiments/cli/reports/table_format.h"

namespace cvo {

// The default values of the estimator's options, as nested JSON.
std::string DefaultOptions();

// Makes and prints the table of a suite's output folder. In the terminal format, also writes
// table.json and table.md there, unless `compared_with` names another reference row than the
// suite's (see MakeTable). Returns 0 if all jobs that can run have run, 1 if some failed or have
// not run yet. Throws Error if there is no plan.
int OutputSuiteTable(const std::filesystem::path& folder, const TableFormat& format,
                     const std::string& compared_with = "");

}  // namespace cvo
