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

// What Slurm is set up for.
struct SlurmSetup {
  std::size_t array_size = 0;  // most tasks of one array
  bool accounting = false;     // sacct knows about tasks that left the queue
};

// One task that the queue knows about: waiting, running, or ended not long ago.
struct SlurmTask {
  std::string job;     // of the array: "123"
  std::string state;   // "PENDING", "RUNNING", "COMPLETED", ...
  std::string reason;  // why it waits
};
// By name of the array and number.
using SlurmQueue = std::map<std::pair<std::string, std::size_t>, SlurmTask>;

// Whether a task in this state is over and does not come back by itself.
bool IsTaskFinished(const std::string& state);

enum class SlurmRefusal {
  kPermanent,  // an unknown partition, too much memory, ...
  kLimit,      // too many tasks, or another limit of this user: Slurm does not tell
  kQueueFull,  // too many tasks in the queue at present
};

// What became of an array that was to be submitted.
struct SlurmSubmitted {
  std::string job;      // empty: refused
  std::string refused;  // Slurm's words
  SlurmRefusal refusal = SlurmRefusal::kPermanent;
};

// Slurm does not answer; what was submitted goes on without us.
class SlurmUnreachable : public Error {
 public:
  using Error::Error;
};

// Slurm's commands. While Slurm does not answer they are tried again, less and less often, and the
// user is told once; after `patience_s`, or when `stop` says so, SlurmUnreachable is thrown.
class SlurmClient {
 public:
  SlurmClient(double patience_s, EngineHooks hooks);

  // Throws Error where there is no Slurm, or none that has arrays.
  SlurmSetup Setup() const;
  SlurmQueue Queue(const std::vector<std::string>& names) const;
  SlurmSubmitted Submit(const SlurmArray& array, const std::vector<std::string>& flags) const;
  // Jobs or tasks ("123", "123_4"). Those that are over are passed by.
  void Cancel(const std::vector<std::string>& jobs) const;
  // "TIMEOUT", "CANCELLED by 0", ... of a task that left the queue; empty: not known.
  std::string AccountedState(const std::string& job, std::size_t number) const;

  // Waits, asking `stop` often. False as soon as that says so.
  bool Pause(double seconds) const;

 private:
  using Judge = std::function<bool(const Captured&)>;
  Captured Ask(const std::vector<std::string>& argv, double patience_s, const Judge& silent) const;
  std::optional<std::string> Find(const std::string& name) const;

  double patience_s_;
  EngineHooks hooks_;
};

}  // namespace cvo
