// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "experiments/jobs/engine.h"

namespace cvo {

struct SlurmOptions {
  std::filesystem::path folder;           // of its own, absolute, seen by all machines
  std::vector<std::string> sbatch_flags;  // for every task: "--partition=short", one word each
  int at_once = 0;                        // tasks that run at a time; 0: as many as Slurm starts
  double poll_s = 5.0;                    // between two looks at the queue
  double patience_s = 1800.0;             // Slurm may be silent for so long before Run gives up
  double full_s = 30.0;                   // until an array that found no room is submitted again
  double latency_s = 30.0;                // until a file that one machine wrote is seen by another

  // Throws Error naming the field that makes no sense.
  void Check() const;
};

// Tasks as job arrays of Slurm. What was submitted is on record in the folder: where Run is killed
// and comes again, tasks that still wait or run are followed and not submitted twice, and those
// that are not asked for any more are cancelled. Where Slurm stays silent Run throws, and its tasks
// go on; `stop` cancels them all.
class SlurmEngine : public Engine {
 public:
  explicit SlurmEngine(SlurmOptions options);

  void Run(std::span<const Task> tasks, const EngineHooks& hooks) override;

 private:
  SlurmOptions options_;
};

}  // namespace cvo
