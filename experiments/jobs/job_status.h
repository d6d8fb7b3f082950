// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "experiments/jobs/suite_folder.h"
#include "experiments/suite/plan/plan.h"

namespace cvo {

struct JobStatus {
  enum class State {
    kDone,
    kFailed,      // the last try did, or its sequence cannot be made or read
    kMissing,     // not run yet, or stopped
    kNoSequence,  // the user does not have it
  };
  State state = State::kMissing;
  std::string message;  // why; empty where done
};
const char* ToString(JobStatus::State state);

// What the files say of a job, whatever wrote them. Only a complete result of this very job counts:
// anything else in its place is as none.
JobStatus StatusOf(const SuiteFolder& folder, const PlannedJob& job);

// Whether the files that make the job done are there, whatever is in them.
bool HasFiles(const SuiteFolder& folder, const PlannedJob& job);

// Why the job is not done; empty: it is.
std::string ProblemOfResult(const SuiteFolder& folder, const PlannedJob& job);

// In the order of the plan; cells with the same identity share their status.
std::vector<JobStatus> StatusOfAll(const SuiteFolder& folder, const Plan& plan);

// "indoor_1 full, seed 3, pairwise.alpha=5".
std::string Describe(const Cell& cell);

// Writes failed/<id>.json: the message, and the end of what the job printed. Throws Error.
void WriteFailure(const SuiteFolder& folder, const std::string& id, const std::string& message);

// The last line of a log that is the program's own error, without its prefix; empty: there is none.
std::string ErrorInLog(const std::filesystem::path& log);

}  // namespace cvo
