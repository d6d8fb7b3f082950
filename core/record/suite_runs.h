// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/record/run_summary.h"

namespace cvo::reports {

// A job as stored in plan.json. Its keys are sequence, detections, variant (for another system: its
// name), oracle, and the path of every option that the suite varies.
struct PlannedRun : ExpectedRun {
  std::map<std::string, std::string> keys;
  bool system = false;  // trajectories of another system, scored as they are
  std::string family;   // family that the scene is drawn from; empty: none
  std::string split;    // "development", "test", "none"; "given": images; empty: an older plan
  std::string missing;  // why there is no job
};

// Value of a suite's reference with which each row is compared with the one before it.
inline constexpr std::string_view kRowAbove = "the row above";

struct SuitePlan {
  std::filesystem::path file;
  std::string name;
  std::string about;
  std::vector<std::string> rows;
  std::vector<std::string> metrics;
  std::string reference;  // a variant, key=value or kRowAbove
  std::vector<PlannedRun> runs;
};

// Throws Error naming the file and the field for an incomplete file, another schema, or a plan
// without jobs.
SuitePlan ReadPlan(const std::filesystem::path& plan_file);

// Outcome of a job. Its state is "ok", "lost", "failed", "not run" or "no data".
struct SuiteRun {
  PlannedRun planned;
  std::string state;
  std::string message;
  std::string log;
  std::optional<RunSummary> run;  // of states "ok" and "lost"
};

// Reads the results that exist, with these metrics. One that cannot be read is "failed".
std::vector<SuiteRun> ReadRuns(const std::filesystem::path& folder, const SuitePlan& plan,
                               const std::vector<std::string>& metrics);

// Returns the value of a key or of "family"; "default" for an option that the run does not set.
std::string KeyOf(const PlannedRun& run, const std::string& key);

}  // namespace cvo::reports
