// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "experiments/runner/run_job.h"
#include "experiments/suite/build_plan.h"
#include "experiments/suite/engine.h"
#include "experiments/suite/job_status.h"

namespace cvo {

// Runs one job of the plan, on one thread unless the suite sets timed_threads, and writes its
// files, result.json last. Throws Error if there is no such job, if the program or the sequence's
// files differ from those planned, or if the estimator failed; then there is no result. Features
// are shared with other jobs below `cache`; `notice` is told of what the cache cannot do.
void RunPlannedJob(const Plan& plan, const std::string& id, const SuiteFolder& folder,
                   const std::filesystem::path& cache, const Notice& notice);

// Parameters and callbacks of RunPlan.
struct PlanRun {
  SuiteFolder folder;    // locked by the caller (FolderLock), has the plan.json of this plan
  std::string program;   // absolute path of clustervo, for `experiment job`
  double limit_s = 0.0;  // wall time of one job; 0: no limit
  // Address space of one job, 10^6 bytes; 0: no limit.
  double limit_memory_mb = 0.0;
  std::function<bool()> stop = [] { return false; };
  // Called once at the start, then after each job that ended. Counts only jobs that had to run.
  std::function<void(std::size_t ended, std::size_t total)> progress = [](std::size_t,
                                                                          std::size_t) {};
  // Receives one line for the user, from the engine or about a failed job.
  std::function<void(const std::string& line)> notice = [](const std::string&) {};
};

// Number of cells of the plan by outcome.
struct PlanOutcome {
  std::size_t done = 0;
  std::size_t failed = 0;
  std::size_t missing = 0;  // not run, because the run was stopped
  std::size_t no_sequence = 0;
  bool stopped = false;
};

PlanOutcome CountJobs(const std::vector<JobStatus>& jobs);

// Runs the jobs that are not done, first one per distinct input, so that what they share is ready
// for the others. A failed job is recorded in failed/ and affects no other job. Throws Error if the
// folder can no longer take results; finished jobs are kept.
PlanOutcome RunPlan(const Plan& plan, const PlanRun& run, Engine& engine);

// Runs what a plan needs beforehand, such as scenes to render. Returns one message per task, empty
// for a task that succeeded, or nothing if `stop` ended the run.
[[nodiscard]] std::optional<std::vector<std::string>> RunPreparations(
    const std::vector<Task>& tasks, const PlanRun& run, Engine& engine);

}  // namespace cvo
