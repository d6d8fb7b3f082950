// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <stdlib.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <optional>
#include <sstream>
#include <thread>

#include "core/base/lists.h"
#include "core/files/atomic_file.h"
#include "core/files/json/json_record.h"
#include "core/files/sha256.h"
#include "core/files/text/number.h"
#include "experiments/suite/slurm.h"

namespace cvo {

namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr const char* kRecord = "array.json";
constexpr double kMaxDelayS = 60.0;      // between two retries
constexpr double kCommandLimitS = 60.0;  // a command that hangs longer is killed
constexpr double kStopCheckIntervalS = 0.2;
constexpr int kSignalBase = 128;  // what sh adds to a signal number

// Quotes a text as one word of a POSIX shell, whatever bytes it contains.
std::string ShellQuoted(const std::string& text) {
  std::string quoted = "'";
  for (const char c : text) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

// `timeout` runs in its own subshell, so that the memory limit applies to the task alone. A second
// try may start while the first still runs on a node that Slurm gave up: each writes its own
// temporary file.
constexpr const char* kRunCommand = R"sh(
rm -f -- "$end/$index" "$log" || exit
start=$(date +%s.%N)
(
  if [ "$limit_kib" -gt 0 ]; then ulimit -v "$limit_kib" || exit; fi
  if [ "$limit_s" != 0 ]; then exec timeout --signal=KILL "$limit_s" "$@"; fi
  exec "$@"
) >"$log" 2>&1
code=$?
new="$end/.$index.${SLURM_JOB_ID:-0}.${SLURM_RESTART_COUNT:-0}.$$"
printf '%s\n' "$code $start $(date +%s.%N)" >"$new" && mv -f -- "$new" "$end/$index"
exit "$code"
)sh";

// Returns an sh script that runs the task with number $1, or $SLURM_ARRAY_TASK_ID if there is none,
// within its limits and with its output in its log. Once the task has ended, and not before,
// `folder`/end/<number> contains "<exit code> <start> <end>" (times in seconds). A task that is
// started again removes that file first.
std::string Script(std::span<const Task> tasks, const fs::path& folder) {
  std::string text =
      StrCat("#!/bin/sh\n# One task of a Slurm job array. By hand: sh tasks.sh NUMBER\n",
             "index=${1:-$SLURM_ARRAY_TASK_ID}\nend=", ShellQuoted((folder / "end").string()),
             "\ncase $index in\n");
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    const double limit_mb = kLimitsMemory ? tasks[i].limit_memory_mb : 0.0;
    const auto limit_kib = static_cast<std::int64_t>(std::ceil(limit_mb * 1e6 / 1024.0));
    text += StrCat(i, ")\n  log=", ShellQuoted(tasks[i].log.string()),
                   " limit_s=", tasks[i].limit_s, " limit_kib=", limit_kib, "\n  set --");
    for (const std::string& word : tasks[i].argv) text += " " + ShellQuoted(word);
    text += " ;;\n";
  }
  return text + "*) echo \"no task '$index'\" >&2; exit 2 ;;\nesac\n" + kRunCommand;
}

// Returns the last line that is not empty; empty if there is none.
std::string LastLine(std::istream& lines) {
  std::string last;
  for (std::string line; std::getline(lines, line);) {
    if (!line.empty()) last = line;
  }
  return last;
}

// What a command of Slurm complains about.
std::string Complaint(const Captured& captured) {
  std::istringstream lines(captured.err);
  const std::string last = LastLine(lines);
  return last.empty() ? "no answer" : last;
}

}  // namespace

SlurmArray WriteSlurmArray(const fs::path& root, std::span<const Task> tasks) {
  std::error_code error;
  fs::create_directories(root, error);
  if (error) throw Error(StrCat(root.string(), ": cannot create the folder: ", error.message()));
  std::string folder = (root / "array-XXXXXX").string();
  if (::mkdtemp(folder.data()) == nullptr) ThrowErrno(folder, "create the folder", errno);
  SlurmArray array{folder, "clustervo-" + Sha256Hex(folder).substr(0, 16), {}};
  for (const char* name : {"end", "out"}) fs::create_directories(array.folder / name);
  for (const Task& task : tasks) array.tasks.push_back(task.name);
  WriteFilesAtomically(array.folder,
                       {{"tasks.sh", Script(tasks, array.folder)}, {kRecord, FileText(array)}});
  return array;
}

std::vector<SlurmArray> ReadSlurmArrays(const fs::path& root) {
  std::vector<SlurmArray> arrays;
  if (!fs::exists(root)) return arrays;
  for (const fs::directory_entry& entry : fs::directory_iterator(root)) {
    const fs::path& folder = entry.path();
    if (!folder.filename().string().starts_with("array-")) continue;
    if (!fs::exists(folder / kRecord)) {
      fs::remove_all(folder);
      continue;
    }
    arrays.push_back(ReadRecord<SlurmArray>(folder / kRecord));
    arrays.back().folder = folder;
  }
  std::sort(arrays.begin(), arrays.end(),
            [](const SlurmArray& a, const SlurmArray& b) { return a.folder < b.folder; });
  return arrays;
}

void RemoveSlurmArray(const SlurmArray& array) {
  std::error_code ignored;
  fs::remove_all(array.folder, ignored);
}

std::map<std::size_t, SlurmEnd> ReadSlurmEnds(const SlurmArray& array) {
  std::map<std::size_t, SlurmEnd> ends;
  for (const fs::directory_entry& entry : fs::directory_iterator(array.folder / "end")) {
    const std::optional<std::int64_t> number = ParseInteger(entry.path().filename().string());
    std::ifstream file(entry.path());
    SlurmEnd end;
    double start_s = 0.0;
    double end_s = 0.0;
    if (!number || !(file >> end.code >> start_s >> end_s)) continue;
    end.seconds = std::max(0.0, end_s - start_s);
    ends[static_cast<std::size_t>(*number)] = end;
  }
  return ends;
}

TaskEnd EndByCode(const Task& task, const SlurmEnd& end) {
  const int signal = end.code - kSignalBase;
  if (end.code == 0) return {true, ""};
  if (task.limit_s > 0.0 && signal == SIGKILL && end.seconds >= task.limit_s) {
    return {false, StrCat("stopped after ", task.limit_s, " s")};
  }
  const char* name = signal > 0 ? ::sigabbrev_np(signal) : nullptr;
  const std::string text = name == nullptr
                               ? StrCat("exit code ", end.code)
                               : StrCat("killed by signal ", signal, " (SIG", name, ")");
  return {false, text};
}

TaskEnd EndByState(const SlurmArray& array, std::size_t number, const std::string& state) {
  std::ifstream out(array.folder / "out" / std::to_string(number));
  const std::string words = LastLine(out);  // of Slurm
  return {false, StrCat(state.empty() ? "left Slurm's queue without an exit code"
                                      : "ended by Slurm: " + state,
                        words.empty() ? "" : StrCat(" (", words, ")"))};
}

bool SlurmTask::IsAlive() const {
  static constexpr std::array<const char*, 10> kEnded = {
      "COMPLETED", "FAILED",    "CANCELLED", "TIMEOUT",  "OUT_OF_MEMORY",
      "NODE_FAIL", "BOOT_FAIL", "PREEMPTED", "DEADLINE", "REVOKED"};
  return std::find(kEnded.begin(), kEnded.end(), state) == kEnded.end();
}

namespace {

double Since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

std::size_t ToCount(const std::string& text) {
  std::istringstream in(text);
  std::size_t count = 0;
  in >> count;
  return count;
}

std::vector<std::string> SbatchCommand(const SlurmArray& array,
                                       const std::vector<std::string>& flags) {
  std::vector<std::string> argv = {"sbatch", "--parsable"};
  argv.insert(argv.end(), flags.begin(), flags.end());
  std::string out;
  for (const char c : (array.folder / "out").string()) out += c == '%' ? "%%" : std::string(1, c);
  argv.insert(argv.end(), {"--job-name=" + array.name, "--requeue", "--open-mode=truncate",
                           "--output=" + out + "/%a",
                           "--wrap=exec sh " + ShellQuoted((array.folder / "tasks.sh").string())});
  return argv;
}

}  // namespace

SlurmClient::SlurmClient(double patience_s, EngineHooks hooks)
    : patience_s_(patience_s), hooks_(std::move(hooks)) {}

bool SlurmClient::Pause(double seconds) const {
  const Clock::time_point start = Clock::now();
  while (!hooks_.stop()) {
    const double left_s = seconds - Since(start);
    if (left_s <= 0.0) return true;
    std::this_thread::sleep_for(
        std::chrono::duration<double>(std::min(left_s, kStopCheckIntervalS)));
  }
  return false;
}

Captured SlurmClient::Ask(const std::vector<std::string>& argv) const {
  const Clock::time_point start = Clock::now();
  for (double delay_s = 1.0;; delay_s = std::min(2.0 * delay_s, kMaxDelayS)) {
    const Clock::time_point asked = Clock::now();
    const Captured captured = Capture(
        argv, [&](const Captured&) { return Since(asked) > kCommandLimitS || hooks_.stop(); });
    if (captured.exit_code == 0) {
      if (delay_s > 1.0) hooks_.notice("slurm: responds again");
      return captured;
    }
    const std::string words = StrCat(argv.front(), ": ", Complaint(captured));
    if (delay_s == 1.0) hooks_.notice(StrCat("slurm: ", words, ": retrying"));
    const double left_s = patience_s_ - Since(start);
    if (left_s <= 0.0 || !Pause(std::min(delay_s, left_s))) {
      throw SlurmUnreachable(StrCat("Slurm does not respond: ", words));
    }
  }
}

SlurmQueue SlurmClient::Queue(const std::vector<std::string>& names) const {
  SlurmQueue queue;
  if (names.empty()) return queue;
  const Captured answer =
      Ask({"squeue", "--noheader", "--array", "--states=all", StrCat("--user=", ::geteuid()),
           "--name=" + Joined(names, ","), "--format=%j|%F|%K|%T"});
  std::istringstream lines(answer.out);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream fields(line);
    std::string name;
    std::string number;
    SlurmTask task;
    if (std::getline(fields, name, '|') && std::getline(fields, task.job, '|') &&
        std::getline(fields, number, '|') && std::getline(fields, task.state)) {
      queue[{name, ToCount(number)}] = task;
    }
  }
  return queue;
}

SlurmSubmitted SlurmClient::Submit(const SlurmArray& array,
                                   const std::vector<std::string>& flags) const {
  // If the queue is full, sbatch itself would retry for minutes.
  const Captured answer =
      Capture(SbatchCommand(array, flags),
              [start = Clock::now()](const Captured&) { return Since(start) > kCommandLimitS; });
  if (answer.exit_code == 0) return {answer.out.substr(0, answer.out.find_first_of(";\n")), ""};
  // The array may have been accepted even so, if only the answer was lost.
  const SlurmQueue queue = Queue({array.name});
  if (!queue.empty()) return {queue.begin()->second.job, ""};
  return {"", Complaint(answer)};  // "sbatch: error: ..."
}

// That a task has ended meanwhile is no reason to try again.
void SlurmClient::Cancel(const std::vector<std::string>& jobs) const {
  if (jobs.empty()) return;
  std::vector<std::string> argv = {"scancel", "--quiet"};
  argv.insert(argv.end(), jobs.begin(), jobs.end());
  Capture(argv, [start = Clock::now()](const Captured&) { return Since(start) > kCommandLimitS; });
}

}  // namespace cvo
