// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace cvo::reports {

// Times of a suite's runs as texts; values are medians over the runs of a row.
struct SuiteTimes {
  // Header first, rows in the order of the plan. The last column is the time per frame divided by
  // that of the first row with the same scenes and variant.
  std::vector<std::vector<std::string>> table;
  std::vector<std::string> machines;  // distinct processors with their numbers of threads
};

// Reads the times of the finished runs in a suite's output folder; the runs of one family form one
// row. Throws Error if there is no plan, or if no run is finished.
SuiteTimes ReadSuiteTimes(const std::filesystem::path& folder);

}  // namespace cvo::reports
