// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/files/json/json.h"
#include "experiments/suite/cell.h"

namespace cvo {

// Values of PlannedJob::missing for input that only has to be made first.
inline constexpr char kNotRendered[] = "not rendered yet";
inline constexpr char kNotDetected[] = "boxes not found yet";
inline bool IsPending(const std::string& missing) {
  return missing == kNotRendered || missing == kNotDetected;
}

// PlannedJob::missing starts with this if a file of boxes, labels or a network does not exist,
// which is not a failure.
inline constexpr std::string_view kNoFile = "no file ";

// A cell with its input located.
struct PlannedJob {
  Cell cell;
  // Absolute path of the sequence. Empty if the sequence is missing, but not if it cannot be read.
  std::string folder;
  std::string missing;     // why there is no sequence, or a reason for which IsPending holds
  int frames = 0;          // 0: unknown
  std::string content;     // ContentHash; empty where the sequence is missing
  std::string input;       // key of the front end's output, equal for jobs that share it
  std::string job;         // JobIdentity; empty where the sequence is missing
  std::string boxes = {};  // file written by a detector; empty: none
};

// Everything that a suite runs, as stored in plan.json in its output folder.
struct Plan {
  Suite suite;
  std::string build;  // BuildInfo::identity
  std::string data;   // absolute path to the files of boxes, labels and systems; empty: none
  std::vector<PlannedJob> jobs;
};

// Returns the content of plan.json, a reports::PlanFile.
std::string PlanText(const Plan& plan);
Plan ParsePlan(const Json& json, const std::string& where);

}  // namespace cvo
