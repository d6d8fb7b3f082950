// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// Arrays of tasks for Slurm as folders: what each task runs, and how it ended.
#include <stdlib.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <optional>

#include "core/base/error.h"
#include "core/files/atomic_file.h"
#include "core/files/json/json_record.h"
#include "core/files/sha256.h"
#include "core/files/text/number.h"
#include "experiments/suite/slurm.h"

namespace cvo {
namespace {

namespace fs = std::filesystem;

constexpr const char* kRecord = "array.json";
constexpr int kSignalBase = 128;  // what sh adds to a signal number

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

}  // namespace

std::string ShellQuoted(const std::string& text) {
  std::string quoted = "'";
  for (const char c : text) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

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

}  // namespace cvo
