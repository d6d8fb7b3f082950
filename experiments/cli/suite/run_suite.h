// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <iosfwd>
#include <memory>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "experiments/suite/build_plan.h"
#include "experiments/suite/collection.h"
#include "experiments/suite/engine.h"
#include "experiments/suite/job_status.h"
#include "experiments/suite/suite.h"

namespace cvo {

// Flags that select a suite, its data and its output folder.
struct SuiteFlags {
  std::string suite;
  SuiteSweep sweep;  // with scenes: instead of `suite`
  std::string output;
  std::string data;
  SuiteOverrides overrides;

  void AddTo(CLI::App& app);
  // Throws Error for an invalid suite.
  Suite Load() const;
  // Sets the data folder, which is --data, else CLUSTERVO_DATA, else empty, and the cache folder.
  PlanRequest Request() const;
};

// Flags that select where jobs run.
struct EngineFlags {
  std::string name = "local";
  int jobs = 0;  // in parallel; 0: not specified
  std::vector<std::string> sbatch;

  void AddTo(CLI::App& app);
  // Throws Error for flags that do not apply to the engine.
  std::unique_ptr<Engine> Make(const SuiteFolder& folder) const;
};

// Flags of clustervo experiment run.
struct SuiteRunFlags {
  SuiteFlags suite;
  EngineFlags engine;
  double limit_s = 3600.0;          // wall time of one job; 0: unlimited
  double limit_memory_mb = 8000.0;  // address space of one job; 0: unlimited
  bool quiet = false;
};

// None of the suite's sequences is below --data. The plan has been written.
class NoSequence : public Error {
 public:
  using Error::Error;
};

// Renders, plans and runs a suite. Returns the exit code. Throws Error for an invalid suite or a
// folder that cannot be written, and NoSequence.
int RunSuite(const SuiteRunFlags& flags);

// Runs the suites of a collection, each to a folder with its name below the output folder, and
// writes index.html there. Returns 0 if all jobs that can run have run; a suite without any
// sequence on this disk is not a failure. Throws Error as RunSuite.
int RunCollection(const Collection& collection, const SuiteRunFlags& flags);

// Plans a suite, with its progress on a terminal. `stop` is called before each job; it may throw.
BuiltPlan PlanSuite(
    const Suite& suite, const SuiteFlags& flags, bool quiet,
    const std::function<void()>& stop = [] {});

// Prints "80 jobs: 76 done, 2 failed, 2 with missing input", then a line for each failed job, with
// its message and log, and for each sequence with missing input.
void PrintJobs(const SuiteFolder& folder, const Plan& plan, const std::vector<JobStatus>& status,
               std::ostream& out);

}  // namespace cvo
