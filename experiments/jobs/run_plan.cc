// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/jobs/run_plan.h"

#include <chrono>
#include <cmath>
#include <optional>
#include <set>
#include <system_error>
#include <thread>
#include <utility>

#include "core/base/error.h"
#include "core/files/temporary.h"
#include "experiments/jobs/job_status.h"

namespace cvo {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

// Free space below which a disk counts as full: what running jobs may still write.
constexpr std::uintmax_t kReserve_bytes = 16'000'000;
constexpr std::chrono::milliseconds kRecheckInterval(200);

void CheckSpace(const fs::path& root) {
  std::error_code error;
  const fs::space_info space = fs::space(root, error);
  if (error || space.available >= kReserve_bytes) return;
  ThrowError(root.string(),
             StrCat("a full disk, ", std::floor(static_cast<double>(space.available) / 1e5) / 10.0,
                    " MB free"),
             StrCat("at least ", kReserve_bytes / 1'000'000, " MB; finished jobs are kept"));
}

void MakeFolder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw Error(StrCat(folder.string(), ": cannot create: ", error.message()));
}

std::string MessageOf(const TaskEnd& end, const fs::path& log) {
  const std::string error = end.message.starts_with("exit code") ? ErrorInLog(log) : "";
  return error.empty() ? end.message : error;
}

// The jobs of the plan that are not done, each once, with the first job of each input listed
// separately.
struct Pending {
  std::vector<const PlannedJob*> first;
  std::vector<const PlannedJob*> rest;
};

Pending FindPending(const Plan& plan, const std::vector<JobStatus>& status) {
  Pending pending;
  std::set<std::string> jobs;
  std::set<std::string> inputs;
  for (std::size_t i = 0; i < plan.jobs.size(); ++i) {
    const PlannedJob& job = plan.jobs[i];
    if (job.job.empty() || status[i].state == JobStatus::State::kDone) continue;
    if (!jobs.insert(job.job).second) continue;
    (inputs.insert(job.input).second ? pending.first : pending.rest).push_back(&job);
  }
  return pending;
}

void CancelUnplannedTasks(const Plan& plan, const PlanRun& run, Engine& engine) {
  std::set<std::string> names;
  for (const PlannedJob& job : plan.jobs) names.insert(job.job);
  EngineHooks hooks;
  hooks.stop = run.stop;
  hooks.notice = run.notice;
  engine.KeepOnly(names, hooks);
}

// A failure file beside a result stems from an earlier try.
void RemoveFailure(const SuiteFolder& folder, const std::string& id) {
  std::error_code ignored;
  fs::remove(folder.failure(id), ignored);
}

// Runs jobs in batches and records a problem with the folder itself.
class JobRunner {
 public:
  JobRunner(const PlanRun& run, Engine& engine, std::size_t total)
      : run_(run), engine_(engine), total_(total) {
    run_.progress(0, total_);
  }

  // Throws Error if the folder can no longer take results.
  void Run(const std::vector<const PlannedJob*>& jobs) {
    if (jobs.empty() || Stopped()) return;
    std::vector<Task> tasks;
    for (const PlannedJob* job : jobs) tasks.push_back(TaskOf(*job));
    EngineHooks hooks;
    hooks.ended = [&](std::size_t task, const TaskEnd& end) { Judge(*jobs[task], end); };
    hooks.stop = [this] { return problem_.has_value() || Stopped(); };
    hooks.notice = run_.notice;
    engine_.Run(tasks, hooks);
    if (problem_) throw Error(*problem_);
  }

  // Once `stop` has returned true, this stays true.
  bool Stopped() { return stopped_ = stopped_ || run_.stop(); }

 private:
  Task TaskOf(const PlannedJob& job) const {
    return {.name = job.job,
            .argv = {run_.program, "experiment", "job", fs::absolute(run_.folder.root).string(),
                     job.job},
            .log = run_.folder.log(job.job),
            .limit_s = run_.limit_s,
            .limit_memory_mb = run_.limit_memory_mb};
  }

  // The result of a task that ran on another machine may become visible late.
  bool IsDone(const PlannedJob& job, const TaskEnd& end) {
    const auto start = Clock::now();
    const std::chrono::duration<double> late(end.ok ? engine_.latency_s() : 0.0);
    while (StatusOf(run_.folder, job).state != JobStatus::State::kDone) {
      if (Clock::now() - start >= late || Stopped()) return false;
      std::this_thread::sleep_for(kRecheckInterval);
    }
    return true;
  }

  // An exception must not propagate through the engine: an error here is stored and stops it.
  void Judge(const PlannedJob& job, const TaskEnd& end) {
    if (problem_) return;
    try {
      if (IsDone(job, end)) {
        RemoveFailure(run_.folder, job.job);
      } else if (!stopped_) {
        const std::string message =
            end.ok ? ProblemOfResult(run_.folder, job) : MessageOf(end, run_.folder.log(job.job));
        WriteFailure(run_.folder, job.job, message);
        run_.notice(StrCat("failed: ", Describe(job.cell), ": ", message));
      }
      CheckSpace(run_.folder.root);
      run_.progress(++ended_, total_);
    } catch (const Error& error) {
      problem_ = error.what();
    }
  }

  const PlanRun& run_;
  Engine& engine_;
  std::size_t total_;
  std::size_t ended_ = 0;
  bool stopped_ = false;
  std::optional<std::string> problem_;
};

}  // namespace

PlanOutcome CountJobs(const std::vector<JobStatus>& jobs) {
  PlanOutcome outcome;
  for (const JobStatus& job : jobs) {
    switch (job.state) {
      case JobStatus::State::kDone:
        ++outcome.done;
        break;
      case JobStatus::State::kFailed:
        ++outcome.failed;
        break;
      case JobStatus::State::kMissing:
        ++outcome.missing;
        break;
      case JobStatus::State::kNoSequence:
        ++outcome.no_sequence;
        break;
    }
  }
  return outcome;
}

PlanOutcome RunPlan(const Plan& plan, const PlanRun& run, Engine& engine) {
  std::vector<JobStatus> status = StatusOfAll(run.folder, plan);
  for (std::size_t i = 0; i < status.size(); ++i) {
    if (status[i].state == JobStatus::State::kDone) RemoveFailure(run.folder, plan.jobs[i].job);
  }
  CancelUnplannedTasks(plan, run, engine);
  const Pending pending = FindPending(plan, status);
  if (pending.first.empty()) return CountJobs(status);
  for (const char* name : {"jobs", "failed", "logs"}) MakeFolder(run.folder.root / name);
  RemoveTemporaries(run.folder.root / "failed");
  RemoveEmptyFolders(run.folder.root / "jobs");
  CheckSpace(run.folder.root);
  JobRunner runner(run, engine, pending.first.size() + pending.rest.size());
  runner.Run(pending.first);
  runner.Run(pending.rest);
  PlanOutcome outcome = CountJobs(StatusOfAll(run.folder, plan));
  outcome.stopped = runner.Stopped() && outcome.missing + outcome.failed > 0;
  return outcome;
}

std::optional<std::vector<std::string>> RunPreparations(const std::vector<Task>& tasks,
                                                        const PlanRun& run, Engine& engine) {
  std::vector<std::string> messages(tasks.size());
  if (tasks.empty()) return messages;
  MakeFolder(run.folder.root / "logs");
  std::size_t ended = 0;
  run.progress(0, tasks.size());
  EngineHooks hooks;
  hooks.ended = [&](std::size_t task, const TaskEnd& end) {
    if (!end.ok) messages[task] = MessageOf(end, tasks[task].log);
    run.progress(++ended, tasks.size());
  };
  hooks.stop = run.stop;
  hooks.notice = run.notice;
  engine.Run(tasks, hooks);
  if (ended < tasks.size()) return std::nullopt;
  return messages;
}

}  // namespace cvo
