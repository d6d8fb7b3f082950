// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

namespace cvo {

// The estimator's options at their defaults, as nested JSON.
std::string DefaultOptions();

// Writes table.json and table.md to the folder that a suite is run to and prints the table. 0: all
// that can run has run; 1: some jobs failed or did not run yet. Throws Error without a plan.
int WriteSuiteTable(const std::filesystem::path& folder);

}  // namespace cvo
