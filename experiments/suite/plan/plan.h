// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/files/json/json.h"
#include "experiments/suite/cell.h"

namespace cvo {

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

// The content of plan.json, a reports::PlanFile.
std::string PlanText(const Plan& plan);
Plan ParsePlan(const Json& json, const std::string& where);

}  // namespace cvo
