// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <set>
#include <sstream>
#include <thread>
#include <utility>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "experiments/suite/slurm.h"

namespace cvo {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double kStopTimeoutS = 15.0;  // for Slurm to end cancelled tasks
constexpr double kStopPollS = 0.5;
constexpr double kShortestPollS = 0.5;
constexpr double kMaxDelayS = 60.0;          // between two retries
constexpr double kCommandLimitS = 60.0;      // a command that hangs longer is killed
constexpr std::size_t kMostPerArray = 1000;  // Slurm's default limit
constexpr double kPollFraction = 0.05;  // of the elapsed time, so that short suites need not wait

double Since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

// Slurm does not respond. Tasks already submitted continue without us.
class SlurmUnreachable : public Error {
 public:
  using Error::Error;
};

// What a command of Slurm complains about: its last line.
std::string Complaint(const Captured& captured) {
  std::istringstream lines(captured.err);
  std::string last = "no answer";
  for (std::string line; std::getline(lines, line);) {
    if (!line.empty()) last = line;
  }
  return last;
}

// One task known to the queue: waiting, running or recently ended.
struct QueuedTask {
  std::string job;    // job id of the array: "123"
  std::string state;  // "PENDING", "RUNNING", "COMPLETED", ...

  // False if it has ended for good: Slurm will not requeue it by itself.
  bool IsAlive() const {
    static constexpr std::array<const char*, 10> kEnded = {
        "COMPLETED", "FAILED",    "CANCELLED", "TIMEOUT",  "OUT_OF_MEMORY",
        "NODE_FAIL", "BOOT_FAIL", "PREEMPTED", "DEADLINE", "REVOKED"};
    return std::find(kEnded.begin(), kEnded.end(), state) == kEnded.end();
  }
};
// Tasks by (name of the array, task number).
using Queue = std::map<std::pair<std::string, std::size_t>, QueuedTask>;

// The state of one call of SlurmEngine::Run.
class SlurmRun {
 public:
  SlurmRun(const SlurmOptions& options, std::span<const Task> tasks, const EngineHooks& hooks)
      : options_(options), tasks_(tasks), hooks_(hooks) {
    for (const std::string& flag : options.sbatch_flags) {
      if (flag.starts_with("--clusters=") || flag.starts_with("-M")) cluster_flags_ = {flag};
    }
  }

  void RunToCompletion() {
    const Clock::time_point start = Clock::now();
    try {
      ResumeEarlierArrays();
      while (!hooks_.stop()) {
        SubmitWaiting();
        if (Open() == 0 && waiting_.empty()) break;
        Pause(std::min(options_.poll_s, std::max(kShortestPollS, Since(start) * kPollFraction)));
        if (!hooks_.stop()) Follow(AskQueue());
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

  // A command of Slurm, about the clusters that tasks are submitted to.
  std::vector<std::string> Command(std::vector<std::string> words) const {
    words.insert(words.begin() + 1, cluster_flags_.begin(), cluster_flags_.end());
    return words;
  }

  // Runs a command once. One that hangs is killed; a question, as soon as the run is stopped.
  Captured Call(const std::vector<std::string>& argv, bool is_question = false) const {
    return Capture(argv, [&, start = Clock::now()](const Captured&) {
      return Since(start) > kCommandLimitS || (is_question && Ended());
    });
  }

  bool Ended() const { return !stopping_ && hooks_.stop(); }

  // Waits. Returns false as soon as the run is stopped.
  bool Pause(double seconds) const {
    constexpr double kStopCheckIntervalS = 0.2;
    const Clock::time_point start = Clock::now();
    while (!Ended()) {
      const double left_s = seconds - Since(start);
      if (left_s <= 0.0) return true;
      std::this_thread::sleep_for(
          std::chrono::duration<double>(std::min(left_s, kStopCheckIntervalS)));
    }
    return false;
  }

  // While Slurm does not respond, retries at increasing intervals; the user is told once. Throws
  // SlurmUnreachable when patience ends or the run is stopped.
  Queue AskQueue() const {
    Queue queue;
    if (followed_.empty()) return queue;
    const std::vector<std::string> argv = Command(
        {"squeue", "--noheader", "--array", "--states=all", StrCat("--user=", ::geteuid()),
         "--name=" + Joined(followed_, ",", [](const Followed& one) { return one.array.name; }),
         "--format=%j|%F|%K|%T"});
    const double patience_s = stopping_ ? kStopTimeoutS : options_.patience_s;
    const Clock::time_point start = Clock::now();
    Captured answer = Call(argv, true);
    for (double delay_s = 1.0; answer.exit_code != 0;
         delay_s = std::min(2.0 * delay_s, kMaxDelayS)) {
      const std::string words = "squeue: " + Complaint(answer);
      if (delay_s == 1.0) hooks_.notice(StrCat("slurm: ", words, ": retrying"));
      const double left_s = patience_s - Since(start);
      if (left_s <= 0.0 || !Pause(std::min(delay_s, left_s))) {
        throw SlurmUnreachable("Slurm does not respond: " + words);
      }
      answer = Call(argv, true);
      if (answer.exit_code == 0) hooks_.notice("slurm: responds again");
    }
    std::istringstream lines(answer.out);
    for (std::string line; std::getline(lines, line);) {
      std::istringstream fields(line);
      std::string name;
      std::string number;
      QueuedTask task;
      if (std::getline(fields, name, '|') && std::getline(fields, task.job, '|') &&
          std::getline(fields, number, '|') && std::getline(fields, task.state)) {
        queue[{name, std::strtoul(number.c_str(), nullptr, 10)}] = task;
      }
    }
    return queue;
  }

  // Takes over our tasks of an earlier array: those that are alive are followed, those that
  // succeeded are reported as ended. Other tasks are left alone.
  void Claim(Followed& followed, const Queue& queue, Wanted& wanted) {
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
    const Queue queue = AskQueue();
    for (Followed& followed : followed_) Claim(followed, queue, wanted);
    std::erase_if(followed_, [](const Followed& followed) {
      const bool idle = followed.open.empty() && !followed.others;
      if (idle) RemoveSlurmArray(followed.array);
      return idle;
    });
    for (const auto& [name, task] : wanted) waiting_.push_back(task);
    std::sort(waiting_.begin(), waiting_.end());
  }

  // Returns the job id, or an empty one with the reason if Slurm refuses the array.
  std::pair<std::string, std::string> Submit(const SlurmArray& array,
                                             const std::vector<Task>& tasks) const {
    std::vector<std::string> argv = {"sbatch", "--parsable"};
    // An array has the largest of its tasks' limits, or none. Its script applies their own: one
    // minute earlier, because Slurm counts whole minutes.
    const auto largest = [&](double Task::*limit) {
      return std::ranges::min(tasks, {}, limit).*limit > 0.0
                 ? std::ranges::max(tasks, {}, limit).*limit
                 : 0.0;
    };
    const double limit_s = largest(&Task::limit_s);
    const double limit_mb = largest(&Task::limit_memory_mb);
    if (limit_s > 0.0) {
      argv.push_back(StrCat("--time=", std::int64_t(std::ceil(limit_s / 60.0)) + 1));
    }
    if (limit_mb > 0.0) {  // Slurm's megabytes are of 2^20 bytes
      argv.push_back(StrCat("--mem=", std::int64_t(std::ceil(limit_mb * 1e6 / 1048576.0))));
    }
    argv.insert(argv.end(), options_.sbatch_flags.begin(), options_.sbatch_flags.end());
    argv.push_back(StrCat("--array=0-", array.tasks.size() - 1));
    if (options_.at_once > 0) argv.back() += StrCat("%", options_.at_once);
    std::string out;
    for (const char c : (array.folder / "out").string()) out += c == '%' ? "%%" : std::string(1, c);
    argv.insert(
        argv.end(),
        {"--job-name=" + array.name, "--requeue", "--open-mode=truncate", "--output=" + out + "/%a",
         "--wrap=exec sh " + ShellQuoted((array.folder / "tasks.sh").string())});
    // If the queue is full, sbatch itself would retry for minutes.
    const Captured answer = Call(argv);
    if (answer.exit_code == 0) return {answer.out.substr(0, answer.out.find_first_of(";\n")), ""};
    // The array may have been accepted even so, if only the answer was lost.
    for (const auto& [where, entry] : AskQueue()) {
      if (where.first == array.name) return {entry.job, ""};
    }
    return {"", Complaint(answer)};  // "sbatch: error: ..."
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
      const auto [job, refused] = Submit(followed.array, tasks);
      if (job.empty()) {
        RemoveSlurmArray(followed.array);
        followed_.pop_back();
        most_at_once_ = std::max<std::size_t>(1, count / 2);
        if (count > 1) continue;
        if (Open() == 0) throw Error(refused);
        return;
      }
      most_at_once_ = std::min(2 * count, kMostPerArray);
      followed.job = job;
      for (std::size_t number = 0; number < count; ++number) {
        followed.open.emplace(number, waiting_.front());
        waiting_.pop_front();
      }
      hooks_.notice(StrCat("slurm: job ", job, ": ", Counted(count, "task"), " submitted"));
    }
  }

  void Follow(const Queue& queue) {
    for (Followed& followed : followed_) {
      if (followed.open.empty()) continue;
      const std::map<std::size_t, SlurmEnd> ends = ReadSlurmEnds(followed.array);
      for (auto it = followed.open.begin(); it != followed.open.end();) {
        const auto [number, task] = *it;
        const std::optional<TaskEnd> end = Judge(followed, number, queue, ends);
        it = end ? followed.open.erase(it) : std::next(it);
        if (end) hooks_.ended(task, *end);
      }
    }
  }

  // Returns nothing while the task is in the queue or its end file may still arrive. A task that
  // runs and has written that it succeeded counts as ended: a controller that crashed may never
  // notice.
  std::optional<TaskEnd> Judge(const Followed& followed, std::size_t number, const Queue& queue,
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
    if (by_itself && Since(since) < options_.latency_s) return std::nullopt;
    if (state == "COMPLETED") return TaskEnd{true, ""};
    return EndByState(followed.array, number, state);
  }

  // Cancels everything, including arrays submitted without our knowledge, and waits for it to end.
  void Stop() {
    stopping_ = true;
    const Clock::time_point start = Clock::now();
    while (Since(start) < kStopTimeoutS) {
      std::set<std::string> jobs;
      for (const auto& [where, entry] : AskQueue()) {
        if (entry.IsAlive()) jobs.insert(entry.job);
      }
      if (jobs.empty()) {
        for (const Followed& followed : followed_) RemoveSlurmArray(followed.array);
        return;
      }
      std::vector<std::string> argv = Command({"scancel", "--quiet"});
      argv.insert(argv.end(), jobs.begin(), jobs.end());
      Call(argv);  // that a task has ended meanwhile is no reason to try again
      Pause(kStopPollS);
    }
    hooks_.notice("slurm: some cancelled tasks have not ended yet: see squeue");
  }

  std::size_t Open() const {
    std::size_t open = 0;
    for (const Followed& followed : followed_) open += followed.open.size();
    return open;
  }

  const SlurmOptions& options_;
  std::span<const Task> tasks_;
  const EngineHooks& hooks_;
  std::vector<std::string> cluster_flags_;
  std::vector<Followed> followed_;
  std::deque<std::size_t> waiting_;  // tasks not submitted yet
  // Tasks that left the queue without an end file: since when.
  std::map<std::size_t, Clock::time_point> lost_;
  std::size_t most_at_once_ = kMostPerArray;  // tasks per array: halved while Slurm refuses them
  bool stopping_ = false;                     // the hooks no longer count
};

}  // namespace

SlurmEngine::SlurmEngine(SlurmOptions options) : options_(std::move(options)) {
  for (const std::string& flag : options_.sbatch_flags) {
    if (flag.size() > 1 && flag.front() == '-') continue;
    ThrowError("flag for sbatch", flag, "a flag in one word, such as --partition=short");
  }
}

void SlurmEngine::Run(std::span<const Task> tasks, const EngineHooks& hooks) {
  if (!tasks.empty()) SlurmRun(options_, tasks, hooks).RunToCompletion();
}

}  // namespace cvo
