// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/files/json.h"
#include "experiments/suite/suite.h"

namespace cvo {

// One run that a suite asks for, before anything is known of its input.
struct Cell {
  SuiteSequence sequence;
  std::string variant;  // of a system: empty
  std::string system;   // name of another system whose files are scored; empty: a variant
  std::uint64_t seed = 0;
  std::vector<std::pair<std::string, Json>> parameters;  // path and value, of the grid
  std::vector<std::string> oracle;
  bool landmarks = false;  // keeps every landmark; no part of what is computed
};

// Value by path.
Json ParametersOf(const Cell& cell);

// PlannedJob::missing of what only has to be made first.
inline constexpr char kNotRendered[] = "not rendered yet";
inline constexpr char kNotDetected[] = "boxes not found yet";
inline bool IsPending(const std::string& missing) {
  return missing == kNotRendered || missing == kNotDetected;
}

// It starts with this where a file of boxes, labels or a network is not there, which is no failure.
inline constexpr std::string_view kNoFile = "no file ";

// A cell with its input found.
struct PlannedJob {
  Cell cell;
  // Absolute, of the sequence; empty where it is missing, but not where it cannot be read.
  std::string folder;
  std::string missing;     // why there is no sequence, or IsPending
  int frames = 0;          // 0: not known
  std::string content;     // ContentHash; empty where the sequence is missing
  std::string input;       // key of what the front end makes of it: equal for jobs that share it
  std::string job;         // JobIdentity; empty where the sequence is missing
  std::string boxes = {};  // file that a detector wrote; empty: there is none
};

// Everything that a suite runs, as plan.json in its output folder keeps it.
struct Plan {
  Suite suite;
  std::string build;  // BuildInfo::identity
  std::string data;   // absolute: files of boxes, labels and systems are below it; empty: none
  std::vector<PlannedJob> jobs;
};

// All cells, sequence by sequence, then seed, parameters, oracle, variant.
std::vector<Cell> ExpandSuite(const Suite& suite);

// The content of plan.json, a reports::PlanFile.
std::string PlanText(const Plan& plan);
Plan ParsePlan(const Json& json, const std::string& where);

}  // namespace cvo
