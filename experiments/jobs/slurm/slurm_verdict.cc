// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/jobs/slurm/slurm_verdict.h"

#include <csignal>
#include <cstring>

#include "core/base/error.h"

namespace cvo {
namespace {

constexpr int kSignalBase = 128;  // what sh adds to a signal number

std::string CodeText(int code) {
  const int signal = code - kSignalBase;
  const char* name = signal > 0 ? ::sigabbrev_np(signal) : nullptr;
  if (name == nullptr) return StrCat("exit code ", code);
  return StrCat("killed by signal ", signal, " (SIG", name, ")");
}

// Slurm appends who cancelled the task: "CANCELLED by 1000".
std::string StateText(const std::string& state) {
  if (state.starts_with("CANCELLED")) return "cancelled in Slurm";
  if (state == "TIMEOUT") return "stopped by Slurm at its time limit";
  if (state == "OUT_OF_MEMORY") return "stopped by Slurm at its memory limit";
  if (state == "NODE_FAIL") return "its node failed";
  if (state.empty()) return "left Slurm's queue without an exit code";
  return StrCat("failed in Slurm (", state, "): check that the nodes can access this folder");
}

}  // namespace

TaskEnd EndByCode(const Task& task, const SlurmEnd& end) {
  if (end.code == 0) return {true, "", end.seconds};
  const bool timed_out =
      task.limit_s > 0.0 && end.code == kSignalBase + SIGKILL && end.seconds >= task.limit_s;
  return {false, timed_out ? StrCat("stopped after ", task.limit_s, " s") : CodeText(end.code),
          end.seconds};
}

TaskEnd EndByState(const std::string& state, const std::string& words) {
  return {false, StateText(state) + (words.empty() ? "" : StrCat(" (", words, ")")), 0.0};
}

}  // namespace cvo
