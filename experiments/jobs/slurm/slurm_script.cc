// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/jobs/slurm/slurm_script.h"

#include <cmath>
#include <cstdint>

#include "core/base/error.h"
#include "experiments/jobs/child_process.h"

namespace cvo {
namespace {

constexpr double kBytesPerLimitMb = 1e6;
constexpr double kBytesPerKib = 1024.0;

// `timeout` runs in its own subshell, so that the memory limit applies to the task alone. A second
// try may start while the first still runs on a node that Slurm gave up: each writes its own
// temporary file. If the disk is full, the task waits with its end for up to ten minutes: without
// the file, a crash of Slurm's controller could leave it running there until its time limit.
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
line="$code $start $(date +%s.%N)"
tries=600
until printf '%s\n' "$line" >"$new" && mv -f -- "$new" "$end/$index"; do
  tries=$((tries - 1))
  [ "$tries" -gt 0 ] && [ -d "$end" ] || break
  sleep 1
done
exit "$code"
)sh";

std::string Case(const Task& task, std::size_t index) {
  const double limit_mb = kLimitsMemory ? task.limit_memory_mb : 0.0;
  const auto limit_kib =
      static_cast<std::int64_t>(std::ceil(limit_mb * kBytesPerLimitMb / kBytesPerKib));
  std::string text = StrCat(index, ")\n  log=", ShellQuoted(task.log.string()),
                            " limit_s=", task.limit_s, " limit_kib=", limit_kib, "\n  set --");
  for (const std::string& word : task.argv) text += StrCat(" ", ShellQuoted(word));
  return text + " ;;\n";
}

}  // namespace

std::string ShellQuoted(const std::string& text) {
  std::string quoted = "'";
  for (const char c : text) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

std::string SlurmScript(std::span<const Task> tasks, const std::filesystem::path& folder) {
  std::string text =
      StrCat("#!/bin/sh\n# One task of a Slurm job array. By hand: sh tasks.sh NUMBER\n",
             "index=${1:-$SLURM_ARRAY_TASK_ID}\nend=", ShellQuoted((folder / "end").string()),
             "\ncase $index in\n");
  for (std::size_t i = 0; i < tasks.size(); ++i) text += Case(tasks[i], i);
  return text + "*) echo \"no task '$index'\" >&2; exit 2 ;;\nesac\n" + kRunCommand;
}

}  // namespace cvo
