// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "experiments/record/timing_file.h"
#include "experiments/runner/run_files.h"
#include "experiments/runner/run_sequence.h"
#include "experiments/runner/score_run.h"

namespace cvo {

struct JobOutcome {
  RunResult run;
  RunScores scores;
  RunContext context;
  std::vector<std::string> warnings = {};  // of FindImplausible, and of much memory
};

// Returns GivenToJson of a job. Classes only count if there are boxes.
Json Given(const Sequence& sequence, const std::vector<std::string>& classes,
           const OracleSwitches& oracle);

// Returns the JobIdentity of what RunJob would do, from the bytes of the sequence's files; nothing
// is decoded. Does not read images whose hashes are in the request.
std::string IdentifyJob(const RunRequest& request);
// The same, if the ContentHash of the sequence is known.
std::string IdentifyJob(const RunRequest& request, const std::string& content);

// Runs the job, scores it and writes its files to an existing folder (WriteRunFiles). Returns
// nothing if the request's `stop` ended the run; no file is written then.
[[nodiscard]] std::optional<JobOutcome> RunJob(const RunRequest& request,
                                               const std::filesystem::path& folder);

}  // namespace cvo
