// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "experiments/jobs/engine.h"

namespace cvo {

struct SlurmOptions {
  std::filesystem::path folder;           // of its own, absolute, seen by all machines
  std::vector<std::string> sbatch_flags;  // for every task: "--partition=short", one word each
  int at_once = 0;                        // tasks that run at a time; 0: as many as Slurm starts
  double poll_s = 10.0;                   // between two looks at the queue, less at the start
  double patience_s = 1800.0;             // Slurm may be silent for so long before Run gives up
  double full_s = 30.0;                   // until an array that found no room is submitted again
  double latency_s = 30.0;                // until a file that one machine wrote is seen by another

  // Throws Error naming the field that makes no sense.
  void Check() const;
};

// Tasks as job arrays of Slurm. What was submitted is on record in the folder: where Run is killed
// and comes again, a task that still waits or runs is followed, and one that succeeded meanwhile
// has ended; nothing is submitted twice. Where Slurm stays silent Run throws and its tasks go on.
// `stop` cancels all that the folder has on record.
class SlurmEngine : public Engine {
 public:
  explicit SlurmEngine(SlurmOptions options);

  void Run(std::span<const Task> tasks, const EngineHooks& hooks) override;

  void KeepOnly(const std::set<std::string>& names, const EngineHooks& hooks) override;
  double latency_s() const override { return options_.latency_s; }

 private:
  SlurmOptions options_;
};

}  // namespace cvo
