// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/base/error.h"
#include "experiments/jobs/capture.h"
#include "experiments/jobs/engine.h"
#include "experiments/jobs/slurm/slurm_array.h"

namespace cvo {

// Relevant configuration of the Slurm installation.
struct SlurmSetup {
  std::size_t array_size = 0;  // maximum number of tasks in one array
  bool accounting = false;     // sacct knows tasks that have left the queue
};

// One task known to the queue: waiting, running or recently ended.
struct SlurmTask {
  std::string job;     // job id of the array: "123"
  std::string state;   // "PENDING", "RUNNING", "COMPLETED", ...
  std::string reason;  // why it is waiting
};
// Tasks by (name of the array, task number).
using SlurmQueue = std::map<std::pair<std::string, std::size_t>, SlurmTask>;

// Whether a task in this state has ended for good: Slurm will not requeue it by itself.
bool IsTaskFinished(const std::string& state);

enum class SlurmRefusal {
  kPermanent,  // an unknown partition, too much memory, ...
  kLimit,      // too many tasks, or another limit of this user; Slurm does not say which
  kQueueFull,  // too many tasks in the queue at the moment
};

// Outcome of submitting an array.
struct SlurmSubmitted {
  std::string job;      // job id; empty if refused
  std::string refused;  // Slurm's message
  SlurmRefusal refusal = SlurmRefusal::kPermanent;
};

// Thrown when Slurm does not respond. Tasks already submitted continue without us.
class SlurmUnreachable : public Error {
 public:
  using Error::Error;
};

// Runs Slurm's commands. While Slurm does not respond, they are retried at increasing intervals,
// and the user is told once. Throws SlurmUnreachable after `patience_s`, or when `stop` returns
// true.
class SlurmClient {
 public:
  SlurmClient(double patience_s, EngineHooks hooks);

  // Throws Error if Slurm is not installed or does not allow arrays.
  SlurmSetup Setup() const;
  SlurmQueue Queue(const std::vector<std::string>& names) const;
  SlurmSubmitted Submit(const SlurmArray& array, const std::vector<std::string>& flags) const;
  // Cancels jobs or tasks ("123", "123_4"). Those that have ended are ignored.
  void Cancel(const std::vector<std::string>& jobs) const;
  // Returns the final state of a task that left the queue, such as "TIMEOUT" or "CANCELLED by 0";
  // empty if unknown.
  std::string AccountedState(const std::string& job, std::size_t number) const;

  // Waits, polling `stop`. Returns false as soon as that returns true.
  bool Pause(double seconds) const;

 private:
  using Judge = std::function<bool(const Captured&)>;
  Captured Ask(const std::vector<std::string>& argv, double patience_s, const Judge& silent) const;
  std::optional<std::string> Find(const std::string& name) const;

  double patience_s_;
  EngineHooks hooks_;
};

}  // namespace cvo
