// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/jobs/slurm/slurm_run.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <set>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "experiments/jobs/slurm/slurm_verdict.h"

namespace cvo {
namespace fs = std::filesystem;
namespace {

constexpr double kBytesPerMb = 1e6;
constexpr double kBytesPerSlurmMb = 1048576.0;
constexpr double kSecondsPerMinute = 60.0;
constexpr double kStopTimeoutS = 15.0;  // for Slurm to end cancelled tasks
constexpr double kStopPollS = 0.5;
constexpr double kShortestPollS = 0.5;
constexpr double kPollFraction = 0.05;  // of the elapsed time, so that short suites need not wait

// Reasons not worth reporting: every task has one of them before it starts.
bool IsOrdinary(const std::string& reason) {
  static const std::set<std::string> kReasons = {"None", "Priority", "Resources", "Dependency",
                                                 "JobArrayTaskLimit"};
  return kReasons.contains(reason);
}

std::string PendingReasonText(const std::string& reason) {
  if (reason == "BeginTime") return "requeued by Slurm, which will start it later";
  const bool held = reason.find("held") != std::string::npos || reason == "JobHeldUser";
  return reason + (held ? " (use scontrol release JOB)" : "");
}

}  // namespace

SlurmRun::SlurmRun(const SlurmOptions& options, std::span<const Task> tasks,
                   const EngineHooks& hooks)
    : options_(options), tasks_(tasks), hooks_(hooks), client_(options.patience_s, hooks) {}

void SlurmRun::RunToCompletion() {
  const Clock::time_point start = Clock::now();
  try {
    setup_ = client_.Setup();
    ResumeEarlierArrays();
    while (!hooks_.stop()) {
      SubmitWaiting();
      if (Open() == 0 && waiting_.empty()) break;
      const double elapsed_s = std::chrono::duration<double>(Clock::now() - start).count();
      client_.Pause(std::min(options_.poll_s, std::max(kShortestPollS, elapsed_s * kPollFraction)));
      if (!hooks_.stop()) Follow(client_.Queue(Names()));
    }
  } catch (const SlurmUnreachable& error) {
    if (!hooks_.stop()) {
      throw Error(StrCat(error.what(),
                         "; submitted jobs continue: run the same command again to follow them"));
    }
  }
  if (hooks_.stop()) return Stop();
  for (const Followed& followed : followed_) {
    if (!followed.others) RemoveSlurmArray(followed.array);
  }
}

// Takes over our tasks of an earlier array: those that are alive are followed, those that succeeded
// are reported as ended.
void SlurmRun::Claim(Followed& followed, const SlurmQueue& queue, Wanted& wanted) {
  const SlurmArray& array = followed.array;
  const std::map<std::size_t, SlurmEnd> ends = ReadSlurmEnds(array);
  for (std::size_t number = 0; number < array.entries.size(); ++number) {
    const auto found = queue.find({array.name, number});
    const bool alive = found != queue.end() && !IsTaskFinished(found->second.state);
    const auto end = ends.find(number);
    if (!alive && (end == ends.end() || end->second.code != 0)) continue;
    if (alive) followed.job = found->second.job;
    const auto task = wanted.tasks.find(array.entries[number].name);
    if (task == wanted.tasks.end()) {
      followed.others = true;
    } else if (array.entries[number].key != TaskKey(tasks_[task->second], options_.sbatch_flags)) {
      if (alive) wanted.outdated.push_back(StrCat(followed.job, "_", number));
    } else {
      if (alive) followed.open.emplace(number, task->second);
      if (!alive) hooks_.ended(task->second, EndByCode(tasks_[task->second], end->second));
      wanted.tasks.erase(task);
    }
  }
}

void SlurmRun::ResumeEarlierArrays() {
  Wanted wanted;
  for (std::size_t i = 0; i < tasks_.size(); ++i) wanted.tasks.emplace(tasks_[i].name, i);
  Require(wanted.tasks.size() == tasks_.size(), "SlurmEngine: a task that is given twice");
  for (SlurmArray& array : ReadSlurmArrays(options_.folder)) {
    followed_.push_back({std::move(array), "", {}, false});
  }
  const SlurmQueue queue = client_.Queue(Names());
  for (Followed& followed : followed_) {
    Claim(followed, queue, wanted);
    if (followed.open.empty()) continue;
    hooks_.notice(StrCat("slurm: job ", followed.job, ", submitted by an earlier run, continues: ",
                         Counted(followed.open.size(), "task")));
  }
  client_.Cancel(wanted.outdated);
  std::erase_if(followed_, [](const Followed& followed) {
    const bool idle = followed.open.empty() && !followed.others;
    if (idle) RemoveSlurmArray(followed.array);
    return idle;
  });
  for (const auto& [name, task] : wanted.tasks) waiting_.push_back(task);
  std::sort(waiting_.begin(), waiting_.end());
}

void SlurmRun::SubmitWaiting() {
  const std::chrono::duration<double> since = Clock::now() - room_.refused;
  if (room_.tasks == 0 && since.count() > options_.full_s) room_.limited = false;
  while (!waiting_.empty() && !hooks_.stop()) {
    if (options_.at_once > 0 && Open() > 0) return;  // Slurm applies this limit per array only
    std::size_t count = std::min(waiting_.size(), setup_.array_size);
    if (room_.limited) count = std::min(count, room_.tasks);
    if (count == 0) return;
    SubmitArray(count);
  }
}

void SlurmRun::SubmitArray(std::size_t count) {
  std::vector<Task> tasks;
  for (std::size_t i = 0; i < count; ++i) tasks.push_back(tasks_[waiting_[i]]);
  followed_.push_back(
      {WriteSlurmArray(options_.folder, tasks, options_.sbatch_flags), "", {}, false});
  Followed& followed = followed_.back();
  const SlurmSubmitted submitted = client_.Submit(followed.array, Flags(tasks));
  if (submitted.job.empty()) {
    RemoveSlurmArray(followed.array);
    followed_.pop_back();
    return Refused(count, submitted);
  }
  followed.job = submitted.job;
  for (std::size_t number = 0; number < count; ++number) {
    followed.open.emplace(number, waiting_.front());
    waiting_.pop_front();
  }
  if (room_.limited) room_.tasks -= count;
  hooks_.notice(StrCat("slurm: job ", followed.job, ": ", Counted(count, "task"), " submitted"));
}

void SlurmRun::Refused(std::size_t count, const SlurmSubmitted& submitted) {
  const bool passing = submitted.refusal == SlurmRefusal::kQueueFull;
  const bool hopeless =
      submitted.refusal == SlurmRefusal::kPermanent || (count == 1 && Open() == 0 && !passing);
  if (hopeless) throw Error(submitted.refused);
  if (count == 1 && !room_.reported) {
    hooks_.notice(StrCat("slurm: accepts no more tasks at present (", submitted.refused,
                         "): ", Counted(waiting_.size(), "task"), " not submitted yet"));
  }
  room_ = {true, count / 2, room_.reported || count == 1, Clock::now()};
}

void SlurmRun::Follow(const SlurmQueue& queue) {
  for (Followed& followed : followed_) {
    if (followed.open.empty()) continue;
    const std::map<std::size_t, SlurmEnd> ends = ReadSlurmEnds(followed.array);
    for (auto it = followed.open.begin(); it != followed.open.end();) {
      const auto [number, task] = *it;
      const auto entry = queue.find({followed.array.name, number});
      const std::optional<TaskEnd> end =
          Judge(followed, number, entry == queue.end() ? nullptr : &entry->second, ends);
      it = end ? followed.open.erase(it) : std::next(it);
      if (!end) continue;
      ++room_.tasks;
      hooks_.ended(task, *end);
    }
  }
  ReportPendingReasons(queue);
}

// Whether the queue and the end file have contradicted each other for long enough that neither will
// change.
bool SlurmRun::IsSettled(std::size_t task) {
  const auto since = contradicted_.emplace(task, Clock::now()).first->second;
  return Clock::now() - since >= std::chrono::duration<double>(options_.latency_s);
}

// Returns nothing while the task is in the queue or its end file may still arrive.
std::optional<TaskEnd> SlurmRun::Judge(const Followed& followed, std::size_t number,
                                       const SlurmTask* entry,
                                       const std::map<std::size_t, SlurmEnd>& ends) {
  const std::size_t task = followed.open.at(number);
  const auto end = ends.find(number);
  std::string state = entry == nullptr ? "" : entry->state;
  if (entry != nullptr && !IsTaskFinished(state)) {
    const bool started = state == "RUNNING" || state == "COMPLETING";
    if (!started || end == ends.end()) {
      contradicted_.erase(task);
      return std::nullopt;
    }
    if (!IsSettled(task)) return std::nullopt;
    // A controller that crashed may not know that a task has ended, and would reserve its
    // processors and memory until its time limit.
    hooks_.notice(StrCat("slurm: job ", followed.job, "_", number,
                         " has ended, but Slurm reports it as ", state, ": cancelled"));
    client_.Cancel({StrCat(followed.job, "_", number)});
    return EndByCode(tasks_[task], end->second);
  }
  const bool by_itself = state.empty() || state == "COMPLETED" || state == "FAILED";
  if (by_itself) {
    if (end != ends.end()) return EndByCode(tasks_[task], end->second);
    if (!IsSettled(task)) return std::nullopt;
  }
  if (state.empty() && setup_.accounting) state = client_.AccountedState(followed.job, number);
  if (state == "COMPLETED") return TaskEnd{true, "", 0.0};
  return EndByState(state, SlurmWords(followed.array, number));
}

void SlurmRun::ReportPendingReasons(const SlurmQueue& queue) {
  std::map<std::string, std::size_t> reasons;
  for (const auto& [where, entry] : queue) {
    if (entry.state == "PENDING" && !IsOrdinary(entry.reason)) ++reasons[entry.reason];
  }
  std::string all;
  for (const auto& [reason, count] : reasons) all += reason + "\n";
  if (all == reported_reason_) return;
  reported_reason_ = all;
  for (const auto& [reason, count] : reasons) {
    hooks_.notice(StrCat("slurm: not started yet: ", Counted(count, "task"), ": ",
                         PendingReasonText(reason)));
  }
}

// Cancels everything, including arrays submitted without our knowledge, and waits for it to end.
void SlurmRun::Stop() {
  EngineHooks hooks = hooks_;
  hooks.stop = [] { return false; };
  const SlurmClient client(kStopTimeoutS, hooks);
  const Clock::time_point start = Clock::now();
  while (Clock::now() - start < std::chrono::duration<double>(kStopTimeoutS)) {
    const SlurmQueue queue = client.Queue(Names());
    std::set<std::string> jobs;
    for (const auto& [where, entry] : queue) {
      if (!IsTaskFinished(entry.state)) jobs.insert(entry.job);
    }
    if (jobs.empty()) {
      for (const Followed& followed : followed_) RemoveSlurmArray(followed.array);
      return;
    }
    client.Cancel({jobs.begin(), jobs.end()});
    client.Pause(kStopPollS);
  }
  hooks_.notice("slurm: some cancelled tasks have not ended yet: see squeue");
}

std::size_t SlurmRun::Open() const {
  std::size_t open = 0;
  for (const Followed& followed : followed_) open += followed.open.size();
  return open;
}

std::vector<std::string> SlurmRun::Names() const {
  std::vector<std::string> names;
  for (const Followed& followed : followed_) names.push_back(followed.array.name);
  return names;
}

// An array has one time limit and one memory limit: the largest of its tasks. Its script applies
// the limit of each task.
std::vector<std::string> SlurmRun::Flags(std::span<const Task> tasks) const {
  double limit_s = 0.0;
  double limit_mb = 0.0;
  bool all_limit_s = true;
  bool all_limit_mb = true;
  for (const Task& task : tasks) {
    limit_s = std::max(limit_s, task.limit_s);
    limit_mb = std::max(limit_mb, task.limit_memory_mb);
    all_limit_s = all_limit_s && task.limit_s > 0.0;
    all_limit_mb = all_limit_mb && task.limit_memory_mb > 0.0;
  }
  std::vector<std::string> flags;
  // One minute more, because Slurm counts whole minutes and the script is meant to stop the task
  // first.
  const auto minutes = static_cast<std::int64_t>(std::ceil(limit_s / kSecondsPerMinute)) + 1;
  if (all_limit_s) flags.push_back(StrCat("--time=", minutes));
  const auto mb = static_cast<std::int64_t>(std::ceil(limit_mb * kBytesPerMb / kBytesPerSlurmMb));
  if (all_limit_mb) flags.push_back(StrCat("--mem=", mb));
  flags.insert(flags.end(), options_.sbatch_flags.begin(), options_.sbatch_flags.end());
  flags.push_back(StrCat("--array=0-", tasks.size() - 1));
  if (options_.at_once > 0) flags.back() += StrCat("%", options_.at_once);
  return flags;
}

}  // namespace cvo
