// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/suite/run_plan.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>
#include <set>
#include <system_error>
#include <thread>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "core/files/atomic_file.h"
#include "experiments/runner/identity.h"
#include "experiments/runner/run_files.h"
#include "experiments/runner/run_job.h"
#include "experiments/runner/system_run.h"
#include "experiments/suite/build_plan.h"
#include "experiments/suite/suite.h"
#include "experiments/suite/system_command.h"
#include "variants/registry.h"

namespace cvo {
namespace {

namespace fs = std::filesystem;

const PlanJob& FindJob(const Plan& plan, const std::string& id, const SuiteFolder& folder) {
  const PlanJob* found = FindBy(plan.jobs, &PlanJob::job, id);
  if (id.empty() || found == nullptr) {
    ThrowError(folder.plan().string(), StrCat("no job \"", id, "\""), "a job of the plan");
  }
  if (plan.build != ThisBuild().identity) {
    ThrowError(folder.plan().string(), "a plan made by another build of this program",
               "one made by this build, see clustervo experiment run");
  }
  return *found;
}

// The folder for the job's files, cleared of temporary files from killed tries.
class JobFolder {
 public:
  JobFolder(const SuiteFolder& folder, const std::string& id)
      : id_(id), output_(folder.job(id), RunFileNames()) {
    RemoveTemporaries(path());
    RemoveTemporaries(path() / "clusters");
  }

  const fs::path& path() const { return output_.path(); }

  // Throws Error if the identity of the job as run differs from the planned one.
  void CheckIdentity(const std::string& made, const Sequence& sequence) const {
    if (made == id_) return;
    RemoveResult();
    ThrowError(sequence.folder.string(),
               StrCat("files or processor level that differ from when the suite was planned (",
                      ThisBuild().cpu_level, " here)"),
               "no change since planning; clustervo experiment run makes a new plan");
  }
  void RemoveResult() const {
    std::error_code ignored;  // a result of another identity does not count anyway
    fs::remove(path() / "result.json", ignored);
  }

 private:
  std::string id_;
  OutputFolder output_;
};

void RunVariant(const Plan& plan, const PlanJob& job, const Sequence& sequence,
                const FrontEndCache& cache, const JobFolder& folder) {
  RunRequest request{.sequence = sequence,
                     .variant = FindVariant(job.variant),
                     .options = OptionsOf(plan.suite, job.variant, job.parameters),
                     .seed = job.seed,
                     .threads = std::max(plan.suite.timed_threads, 1),
                     .classes = ClassesOf(plan.suite.sequences[job.entry]),
                     .oracle = OracleOf(job.oracle),
                     .landmarks = job.landmarks};
  request.images = RenderedHashes(sequence);
  // A timed job extracts its features itself, so that they count in its time.
  if (plan.suite.timed_threads == 0) request.cache = &cache;
  folder.CheckIdentity(IdentifyJob(request), sequence);
  const std::optional<RunResult> run = RunJob(request, folder.path());
  // The identity of the bytes that were processed, which may have changed since the first check.
  folder.CheckIdentity(run->job, sequence);
  if (run->status != RunStatus::kFailed) return;
  folder.RemoveResult();
  throw Error(run->message);
}

void RunSystem(const Plan& plan, const PlanJob& job, const Sequence& sequence,
               const fs::path& cache, const fs::path& inputs, const JobFolder& folder) {
  const SuiteSystem& system = *SystemOf(plan.suite, job);
  const std::vector<ImageHashes> images = RenderedHashes(sequence);
  SystemRequest request{.sequence = sequence,
                        .content = ContentHash(sequence, images),
                        .files = {system.name},
                        .seed = job.seed,
                        .images = ImagesHash(images)};
  const bool runs = !system.command.empty();
  if (runs) request.program = WithInput(IdentifyProgram(system), system, sequence);
  if (!runs) request.files = SystemFilesOf(plan.suite, job, plan.data, cache);
  folder.CheckIdentity(IdentifySystem(request), sequence);
  if (runs) request.files = RunProgram(plan.suite, job, sequence, inputs, folder.path());
  WriteFilesAtomically(folder.path(), {{"result.json", ScoreSystem(request).result}});
}

}  // namespace

void RunPlannedJob(const Plan& plan, const std::string& id, const SuiteFolder& folder,
                   const fs::path& cache, const Notice& notice) {
  const PlanJob& job = FindJob(plan, id, folder);
  const Sequence sequence = OpenSequence(RequestOf(plan.suite, job, plan.data));
  RequireAsRendered(sequence);
  const JobFolder output(folder, id);
  if (!job.system.empty()) {
    RunSystem(plan, job, sequence, cache, folder.inputs(job.input), output);
    return;
  }
  RunVariant(plan, job, sequence, {cache / "frontend", CacheLimit(), notice}, output);
}

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds kRecheckInterval(200);

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
  std::vector<const PlanJob*> first;
  std::vector<const PlanJob*> rest;
};

Pending FindPending(const Plan& plan, const std::vector<JobStatus>& status) {
  Pending pending;
  std::set<std::string> jobs;
  std::set<std::string> inputs;
  for (std::size_t i = 0; i < plan.jobs.size(); ++i) {
    const PlanJob& job = plan.jobs[i];
    if (job.job.empty() || status[i].state == JobStatus::State::kDone) continue;
    if (!jobs.insert(job.job).second) continue;
    (inputs.insert(job.input).second ? pending.first : pending.rest).push_back(&job);
  }
  return pending;
}

// A failure file beside a result stems from an earlier try.
void RemoveFailure(const SuiteFolder& folder, const std::string& id) {
  std::error_code ignored;
  fs::remove(folder.failure(id), ignored);
}

// Runs jobs in batches and records a problem with the folder itself.
class JobRunner {
 public:
  JobRunner(const Suite& suite, const PlanRun& run, Engine& engine, std::size_t total)
      : suite_(suite), run_(run), engine_(engine), total_(total) {
    run_.progress(0, total_);
  }

  // Throws Error if the folder can no longer take results.
  void Run(const std::vector<const PlanJob*>& jobs) {
    if (jobs.empty() || Stopped()) return;
    std::vector<Task> tasks;
    for (const PlanJob* job : jobs) tasks.push_back(TaskOf(*job));
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
  Task TaskOf(const PlanJob& job) const {
    Task task{.name = job.job,
              .argv = {run_.program, "experiment", "job", fs::absolute(run_.folder.root).string(),
                       job.job},
              .log = run_.folder.log(job.job),
              .limit_s = run_.limit_s,
              .limit_memory_mb = run_.limit_memory_mb};
    if (const SuiteSystem* system = SystemOf(suite_, job)) {
      task.limit_s = system->limit_s.value_or(task.limit_s);
      task.limit_memory_mb = system->limit_memory_mb.value_or(task.limit_memory_mb);
    }
    return task;
  }

  // The result of a task that ran on another machine may become visible late.
  bool IsDone(const PlanJob& job, const TaskEnd& end) {
    const auto start = Clock::now();
    const std::chrono::duration<double> late(end.ok ? engine_.latency_s() : 0.0);
    while (StatusOf(run_.folder, job).state != JobStatus::State::kDone) {
      if (Clock::now() - start >= late || Stopped()) return false;
      std::this_thread::sleep_for(kRecheckInterval);
    }
    return true;
  }

  // An exception must not propagate through the engine: an error here is stored and stops it.
  void Judge(const PlanJob& job, const TaskEnd& end) {
    if (problem_) return;
    try {
      if (IsDone(job, end)) {
        RemoveFailure(run_.folder, job.job);
      } else if (!stopped_) {
        const std::string message =
            end.ok ? ProblemOfResult(run_.folder, job) : MessageOf(end, run_.folder.log(job.job));
        WriteFailure(run_.folder, job.job, message);
        run_.notice(StrCat("failed: ", Describe(job), ": ", message));
      }
      run_.progress(++ended_, total_);
    } catch (const Error& error) {
      problem_ = error.what();
    }
  }

  const Suite& suite_;
  const PlanRun& run_;
  Engine& engine_;
  std::size_t total_;
  std::size_t ended_ = 0;
  bool stopped_ = false;
  std::optional<std::string> problem_;
};

}  // namespace

PlanOutcome CountJobs(const std::vector<JobStatus>& jobs) {
  const auto count = [&jobs](JobStatus::State state) {
    return static_cast<std::size_t>(std::count_if(
        jobs.begin(), jobs.end(), [state](const JobStatus& job) { return job.state == state; }));
  };
  return {.done = count(JobStatus::State::kDone),
          .failed = count(JobStatus::State::kFailed),
          .missing = count(JobStatus::State::kMissing),
          .no_sequence = count(JobStatus::State::kNoSequence)};
}

PlanOutcome RunPlan(const Plan& plan, const PlanRun& run, Engine& engine) {
  std::vector<JobStatus> status = StatusOfAll(run.folder, plan);
  for (std::size_t i = 0; i < status.size(); ++i) {
    if (status[i].state == JobStatus::State::kDone) RemoveFailure(run.folder, plan.jobs[i].job);
  }
  const Pending pending = FindPending(plan, status);
  if (pending.first.empty()) return CountJobs(status);
  for (const char* name : {"jobs", "failed", "logs"}) MakeFolder(run.folder.root / name);
  RemoveTemporaries(run.folder.root / "failed");
  JobRunner runner(plan.suite, run, engine, pending.first.size() + pending.rest.size());
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
