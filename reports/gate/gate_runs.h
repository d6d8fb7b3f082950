// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "reports/results/suite_runs.h"

namespace cvo::reports {

// Reference variant for times: across computers and days, only ratios are comparable.
inline constexpr char kTimeReference[] = "static";

// The runs of a folder that the gate considers: those of the program's own variants.
struct GateRuns {
  std::filesystem::path folder;
  std::string suite;
  std::vector<std::string> metrics;  // those read, as far as FindEntry knows them
  std::vector<SuiteRun> runs;
};

// Reads the runs with these metrics or, if there are none, with the table's and their coverage.
// Throws Error as ReadPlan does.
GateRuns ReadGateRuns(const std::filesystem::path& folder, std::vector<std::string> metrics = {});

// Returns the contract that must be equal for runs on one dataset type to be comparable.
Contract GateContract(const RunSummary& run, const MetricValue& metric);

// Returns a label such as "2d3d on indoor_1, seed 2", with the other keys unless they are "none".
std::string RunLabel(const std::map<std::string, std::string>& keys, std::uint64_t seed);

// Returns by job the median time of its estimate divided by that of kTimeReference with otherwise
// the same keys and seed. Omits jobs for which either has no readable timing.json, and those of
// kTimeReference itself.
std::map<std::string, double> TimeRatios(const GateRuns& runs);

}  // namespace cvo::reports
