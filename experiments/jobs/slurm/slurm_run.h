// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <deque>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "experiments/jobs/slurm/slurm_client.h"
#include "experiments/jobs/slurm/slurm_engine.h"

namespace cvo {

// The state of one call of SlurmEngine::Run.
class SlurmRun {
 public:
  SlurmRun(const SlurmOptions& options, std::span<const Task> tasks, const EngineHooks& hooks);

  void RunToCompletion();

 private:
  using Clock = std::chrono::steady_clock;
  struct Followed {
    SlurmArray array;
    std::string job;  // job id; empty: not known to be submitted
    // Our tasks that are not known to have ended: index into tasks_, by task number.
    std::map<std::size_t, std::size_t> open;
    bool others = false;  // contains tasks of other runs
  };

  // Our tasks that are not submitted yet, and outdated tasks that stand in their way.
  struct Wanted {
    std::map<std::string, std::size_t> tasks;  // by name
    std::vector<std::string> outdated;         // "<job>_<number>" of tasks with another command
  };
  // Number of tasks that Slurm accepts, known only from its refusals.
  struct Room {
    bool limited = false;
    std::size_t tasks = 0;        // meaningful only if limited
    bool reported = false;        // to the user
    Clock::time_point refused{};  // time of the last refusal
  };

  void ResumeEarlierArrays();
  void Claim(Followed& followed, const SlurmQueue& queue, Wanted& wanted);
  void SubmitWaiting();
  void SubmitArray(std::size_t count);
  void Refused(std::size_t count, const SlurmSubmitted& submitted);
  void Follow(const SlurmQueue& queue);
  bool IsSettled(std::size_t task);
  std::optional<TaskEnd> Judge(const Followed& followed, std::size_t number, const SlurmTask* entry,
                               const std::map<std::size_t, SlurmEnd>& ends);
  void ReportPendingReasons(const SlurmQueue& queue);
  void Stop();
  std::size_t Open() const;
  std::vector<std::string> Names() const;
  std::vector<std::string> Flags(std::span<const Task> tasks) const;

  const SlurmOptions& options_;
  std::span<const Task> tasks_;
  const EngineHooks& hooks_;
  SlurmClient client_;
  SlurmSetup setup_;
  std::vector<Followed> followed_;
  std::deque<std::size_t> waiting_;  // tasks not submitted yet
  // Tasks that left the queue without an end file, or have one and are still running there: since
  // when.
  std::map<std::size_t, Clock::time_point> contradicted_;
  Room room_;
  std::string reported_reason_;  // why tasks are pending, as last reported
};

}  // namespace cvo
