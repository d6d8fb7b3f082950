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
    kFailed,      // the last try failed, or the sequence cannot be made or read
    kMissing,     // not run yet, or stopped before it ended
    kNoSequence,  // the user does not have the sequence
  };
  State state = State::kMissing;
  std::string message;  // the reason; empty if done
};
const char* ToString(JobStatus::State state);

// Returns the status of a job according to its files, whatever wrote them. Only a complete result
// of exactly this job counts; anything else in its place is ignored.
JobStatus StatusOf(const SuiteFolder& folder, const PlannedJob& job);

// Whether the files of a finished job exist, regardless of their content.
bool HasFiles(const SuiteFolder& folder, const PlannedJob& job);

// Returns why the job is not done; empty if it is.
std::string ProblemOfResult(const SuiteFolder& folder, const PlannedJob& job);

// Returns one status per job, in the order of the plan. Cells with the same identity share theirs.
std::vector<JobStatus> StatusOfAll(const SuiteFolder& folder, const Plan& plan);

// Describes a cell to the user, as in "indoor_1 full, seed 3, pairwise.alpha=5".
std::string Describe(const Cell& cell);

// Writes failed/<id>.json with the message and the end of the job's log. Throws Error.
void WriteFailure(const SuiteFolder& folder, const std::string& id, const std::string& message);

// Returns the last error line that the program itself wrote to a log, without its prefix; empty if
// there is none.
std::string ErrorInLog(const std::filesystem::path& log);

}  // namespace cvo
