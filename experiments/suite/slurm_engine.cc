// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "experiments/suite/slurm.h"

namespace cvo {

namespace {

using Clock = std::chrono::steady_clock;
using Seconds = std::chrono::duration<double>;

constexpr double kStopTimeoutS = 15.0;  // for Slurm to end cancelled tasks
constexpr double kStopPollS = 0.5;
constexpr double kShortestPollS = 0.5;
constexpr std::size_t kMostPerArray = 1000;  // Slurm's default limit
constexpr double kPollFraction = 0.05;  // of the elapsed time, so that short suites need not wait

// The state of one call of SlurmEngine::Run.
class SlurmRun {
 public:
  SlurmRun(const SlurmOptions& options, std::span<const Task> tasks, const EngineHooks& hooks)
      : options_(options), tasks_(tasks), hooks_(hooks), client_(options.patience_s, hooks) {}

  void RunToCompletion() {
    const Clock::time_point start = Clock::now();
    try {
      ResumeEarlierArrays();
      while (!hooks_.stop()) {
        SubmitWaiting();
        if (Open() == 0 && waiting_.empty()) break;
        const double elapsed_s = Seconds(Clock::now() - start).count();
        client_.Pause(
            std::min(options_.poll_s, std::max(kShortestPollS, elapsed_s * kPollFraction)));
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

 private:
  struct Followed {
    SlurmArray array;
    std::string job = {};  // job id; empty: not known to be submitted
    // Our tasks that are not known to have ended: index into tasks_, by task number.
    std::map<std::size_t, std::size_t> open = {};
    bool others = false;  // contains tasks of other runs that are alive
  };
  using Wanted = std::map<std::string, std::size_t>;  // tasks not submitted yet, by name

  // Takes over our tasks of an earlier array: those that are alive are followed, those that
  // succeeded are reported as ended. Other tasks are left alone.
  void Claim(Followed& followed, const SlurmQueue& queue, Wanted& wanted) {
    const SlurmArray& array = followed.array;
    const std::map<std::size_t, SlurmEnd> ends = ReadSlurmEnds(array);
    for (std::size_t number = 0; number < array.tasks.size(); ++number) {
      const auto found = queue.find({array.name, number});
      const bool alive = found != queue.end() && found->second.IsAlive();
      const auto end = ends.find(number);
      if (!alive && (end == ends.end() || end->second.code != 0)) continue;
      if (alive) followed.job = found->second.job;
      const auto task = wanted.find(array.tasks[number]);
      if (task == wanted.end()) {
        followed.others = followed.others || alive;
        continue;
      }
      if (alive) followed.open.emplace(number, task->second);
      if (!alive) hooks_.ended(task->second, EndByCode(tasks_[task->second], end->second));
      wanted.erase(task);
    }
    if (followed.open.empty()) return;
    hooks_.notice(StrCat("slurm: job ", followed.job, ", submitted by an earlier run, continues: ",
                         Counted(followed.open.size(), "task")));
  }

  void ResumeEarlierArrays() {
    Wanted wanted;
    for (std::size_t i = 0; i < tasks_.size(); ++i) wanted.emplace(tasks_[i].name, i);
    Require(wanted.size() == tasks_.size(), "SlurmEngine: a task that is given twice");
    for (SlurmArray& array : ReadSlurmArrays(options_.folder)) {
      followed_.push_back({std::move(array)});
    }
    const SlurmQueue queue = client_.Queue(Names());
    for (Followed& followed : followed_) Claim(followed, queue, wanted);
    std::erase_if(followed_, [](const Followed& followed) {
      const bool idle = followed.open.empty() && !followed.others;
      if (idle) RemoveSlurmArray(followed.array);
      return idle;
    });
    for (const auto& [name, task] : wanted) waiting_.push_back(task);
    std::sort(waiting_.begin(), waiting_.end());
  }

  // Slurm may refuse an array for its size, or for the number of tasks of this or of all users: the
  // rest waits until some of ours have ended.
  void SubmitWaiting() {
    while (!waiting_.empty() && !hooks_.stop()) {
      if (options_.at_once > 0 && Open() > 0) return;  // Slurm applies this limit per array only
      const std::size_t count = std::min(waiting_.size(), most_at_once_);
      std::vector<Task> tasks;
      for (std::size_t i = 0; i < count; ++i) tasks.push_back(tasks_[waiting_[i]]);
      followed_.push_back({WriteSlurmArray(options_.folder, tasks)});
      Followed& followed = followed_.back();
      const SlurmSubmitted submitted = client_.Submit(followed.array, Flags(tasks.front(), count));
      if (submitted.job.empty()) {
        RemoveSlurmArray(followed.array);
        followed_.pop_back();
        most_at_once_ = std::max<std::size_t>(1, count / 2);
        if (count > 1) continue;
        if (Open() == 0) throw Error(submitted.refused);
        return;
      }
      most_at_once_ = std::min(2 * count, kMostPerArray);
      followed.job = submitted.job;
      for (std::size_t number = 0; number < count; ++number) {
        followed.open.emplace(number, waiting_.front());
        waiting_.pop_front();
      }
      hooks_.notice(
          StrCat("slurm: job ", followed.job, ": ", Counted(count, "task"), " submitted"));
    }
  }

  void Follow(const SlurmQueue& queue) {
    for (Followed& followed : followed_) {
      if (followed.open.empty()) continue;
      const std::map<std::size_t, SlurmEnd> ends = ReadSlurmEnds(followed.array);
      for (auto it = followed.open.begin(); it != followed.open.end();) {
        const auto [number, task] = *it;
        const std::optional<TaskEnd> end = Judge(followed, number, queue, ends);
        it = end ? followed.open.erase(it) : std::next(it);
        if (!end) continue;
        hooks_.ended(task, *end);
      }
    }
  }

  // Returns nothing while the task is in the queue or its end file may still arrive. A task that
  // runs and has written that it succeeded counts as ended: a controller that crashed may never
  // notice.
  std::optional<TaskEnd> Judge(const Followed& followed, std::size_t number,
                               const SlurmQueue& queue,
                               const std::map<std::size_t, SlurmEnd>& ends) {
    const std::size_t task = followed.open.at(number);
    const auto entry = queue.find({followed.array.name, number});
    const std::string state = entry == queue.end() ? "" : entry->second.state;
    const bool alive = entry != queue.end() && entry->second.IsAlive();
    const bool started = state == "RUNNING" || state == "COMPLETING";
    const bool by_itself = state.empty() || state == "COMPLETED" || state == "FAILED";
    const auto end = ends.find(number);
    if (end != ends.end() && (by_itself || (started && end->second.code == 0))) {
      return EndByCode(tasks_[task], end->second);
    }
    if (alive) return std::nullopt;
    const auto since = lost_.emplace(task, Clock::now()).first->second;
    if (by_itself && Seconds(Clock::now() - since).count() < options_.latency_s)
      return std::nullopt;
    if (state == "COMPLETED") return TaskEnd{true, ""};
    return EndByState(followed.array, number, state);
  }

  // Cancels everything, including arrays submitted without our knowledge, and waits for it to end.
  void Stop() {
    EngineHooks hooks = hooks_;
    hooks.stop = [] { return false; };
    const SlurmClient client(kStopTimeoutS, hooks);
    const Clock::time_point start = Clock::now();
    while (Seconds(Clock::now() - start).count() < kStopTimeoutS) {
      std::set<std::string> jobs;
      for (const auto& [where, entry] : client.Queue(Names())) {
        if (entry.IsAlive()) jobs.insert(entry.job);
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

  std::size_t Open() const {
    std::size_t open = 0;
    for (const Followed& followed : followed_) open += followed.open.size();
    return open;
  }

  std::vector<std::string> Names() const {
    std::vector<std::string> names;
    for (const Followed& followed : followed_) names.push_back(followed.array.name);
    return names;
  }

  // The limits are the same for all tasks of an array. Its script applies them, too.
  std::vector<std::string> Flags(const Task& task, std::size_t count) const {
    std::vector<std::string> flags;
    // One minute more, because Slurm counts whole minutes and the script is meant to stop the task
    // first.
    if (task.limit_s > 0.0) {
      flags.push_back(
          StrCat("--time=", static_cast<std::int64_t>(std::ceil(task.limit_s / 60.0)) + 1));
    }
    if (task.limit_memory_mb > 0.0) {
      const double mebibytes = task.limit_memory_mb * 1e6 / 1048576.0;  // Slurm's megabytes
      flags.push_back(StrCat("--mem=", static_cast<std::int64_t>(std::ceil(mebibytes))));
    }
    flags.insert(flags.end(), options_.sbatch_flags.begin(), options_.sbatch_flags.end());
    flags.push_back(StrCat("--array=0-", count - 1));
    if (options_.at_once > 0) flags.back() += StrCat("%", options_.at_once);
    return flags;
  }

  const SlurmOptions& options_;
  std::span<const Task> tasks_;
  const EngineHooks& hooks_;
  SlurmClient client_;
  std::vector<Followed> followed_;
  std::deque<std::size_t> waiting_;  // tasks not submitted yet
  // Tasks that left the queue without an end file: since when.
  std::map<std::size_t, Clock::time_point> lost_;
  std::size_t most_at_once_ = kMostPerArray;  // tasks per array: halved while Slurm refuses them
};

}  // namespace

void SlurmOptions::Check() const {
  if (!folder.is_absolute()) {
    ThrowError("SlurmOptions: folder", folder.string(), "an absolute path");
  }
  for (const std::string& flag : sbatch_flags) {
    if (flag.size() > 1 && flag.front() == '-') continue;
    ThrowError("flag for sbatch", flag, "a flag in one word, such as --partition=short");
  }
  if (at_once < 0) ThrowError("SlurmOptions: at_once", StrCat(at_once), "0 or more");
}

SlurmEngine::SlurmEngine(SlurmOptions options) : options_(std::move(options)) { options_.Check(); }

void SlurmEngine::Run(std::span<const Task> tasks, const EngineHooks& hooks) {
  if (!tasks.empty()) SlurmRun(options_, tasks, hooks).RunToCompletion();
}

}  // namespace cvo
