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

// The runs of a folder that the gate looks at: those of the program's own variants.
struct GateRuns {
  std::filesystem::path folder;
  std::string suite;
  std::vector<std::string> metrics;  // the table's with their coverage, that FindEntry knows
  std::vector<SuiteRun> runs;
};

// `metrics`: those to read; empty: the table's. Throws Error as ReadPlan.
GateRuns ReadGateRuns(const std::filesystem::path& folder, std::vector<std::string> metrics = {});

// What makes the numbers of runs on one type of dataset comparable.
Contract GateContract(const RunSummary& run, const MetricValue& metric);

// "2d3d on indoor_1, seed 2", with the other keys where they are not "none".
std::string RunLabel(const std::map<std::string, std::string>& keys, std::uint64_t seed);

// By job: the median time of its estimate over that of kTimeReference on the same sequence and
// seed. Jobs lack where either has no timing.json that can be read; so does kTimeReference itself.
std::map<std::string, double> TimeRatios(const GateRuns& runs);

}  // namespace cvo::reports
