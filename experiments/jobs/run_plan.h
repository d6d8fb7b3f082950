// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "experiments/jobs/engine.h"
#include "experiments/jobs/job_status.h"
#include "experiments/jobs/suite_folder.h"
#include "experiments/suite/plan/plan.h"

namespace cvo {

// What RunPlan is asked to do, and what it says meanwhile.
struct PlanRun {
  SuiteFolder folder;    // locked by the caller (FolderLock), with DIR/plan.json of this plan
  std::string program;   // absolute path of clustervo, for `experiment job`
  double limit_s = 0.0;  // of one job, wall time; 0: none
  double limit_memory_mb = 0.0;  // of one job, address space; 0: none
  std::function<bool()> stop = [] { return false; };
  // Once at the start, then after each job that ended: of those that had to run.
  std::function<void(std::size_t ended, std::size_t total)> progress = [](std::size_t,
                                                                          std::size_t) {};
  // One line for the user: of the engine, or of a job that failed.
  std::function<void(const std::string& line)> notice = [](const std::string&) {};
};

// Cells of the plan by what became of them.
struct PlanOutcome {
  std::size_t done = 0;
  std::size_t failed = 0;
  std::size_t missing = 0;  // not run: stopped before
  std::size_t no_sequence = 0;
  bool stopped = false;
};

PlanOutcome CountJobs(const std::vector<JobStatus>& jobs);

// Runs the jobs that are not done: first one per distinct input, so that what they share is there
// for the others. A job that fails is recorded in failed/ and fails nothing else. Throws Error
// where the folder cannot take results any more; what is done stays.
PlanOutcome RunPlan(const Plan& plan, const PlanRun& run, Engine& engine);

// Runs what must be there before a plan can be made, such as scenes to render. Messages of the
// tasks that failed, by task; empty ones for the others. Empty where `stop` ended it.
[[nodiscard]] std::optional<std::vector<std::string>> RunPreparations(
    const std::vector<Task>& tasks, const PlanRun& run, Engine& engine);

}  // namespace cvo
