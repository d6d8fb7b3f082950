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
  std::filesystem::path folder;           // for the engine alone; absolute, visible to all machines
  std::vector<std::string> sbatch_flags;  // for every task, one word each: "--partition=short"
  int at_once = 0;                        // maximum number of running tasks; 0: decided by Slurm
  double poll_s = 10.0;                   // between queries of the queue; shorter at the start
  double patience_s = 1800.0;             // how long Run waits for an unresponsive Slurm
  double full_s = 30.0;                   // until a refused array is submitted again
  double latency_s = 30.0;  // until a file written by one machine is visible to another

  // Throws Error naming an invalid field.
  void Check() const;
};

// Runs tasks as job arrays of Slurm. Every submission is recorded in the folder. If Run is killed
// and called again, tasks that still wait or run are followed, and tasks that succeeded meanwhile
// are reported as ended; nothing is submitted twice. If Slurm stays unresponsive, Run throws and
// its tasks continue. `stop` cancels everything recorded in the folder.
class SlurmEngine : public Engine {
 public:
  explicit SlurmEngine(SlurmOptions options);

  void Run(std::span<const Task> tasks, const EngineHooks& hooks) override;
  double latency_s() const override { return options_.latency_s; }

 private:
  SlurmOptions options_;
};

}  // namespace cvo
