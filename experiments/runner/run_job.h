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
  std::vector<std::string> warnings = {};  // FindImplausible
};

// GivenToJson of a job; classes count where there are boxes alone.
Json Given(const Sequence& sequence, const std::vector<std::string>& classes,
           const OracleSwitches& oracle);

// JobIdentity of what RunJob would do, from the bytes of the sequence's files; nothing is decoded.
// Images whose hashes the request has are not read.
std::string IdentifyJob(const RunRequest& request);
// The same where the ContentHash of the sequence is known.
std::string IdentifyJob(const RunRequest& request, const std::string& content);

// Runs, scores, and writes the files to a folder that exists (WriteRunFiles). Empty where the
// request's `stop` ended the run: nothing is written then. Throws Error on a CPU below the level of
// recorded runs.
[[nodiscard]] std::optional<JobOutcome> RunJob(const RunRequest& request,
                                               const std::filesystem::path& folder);

}  // namespace cvo
