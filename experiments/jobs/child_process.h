// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/types.h>

#include <chrono>
#include <optional>

#include "experiments/jobs/engine.h"

namespace cvo {

// These sanitizers reserve terabytes of address space, more than any memory limit would leave.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr bool kLimitsMemory = false;
#else
inline constexpr bool kLimitsMemory = true;
#endif

// A task running as a process in its own process group. It does not outlive the thread that started
// it: the kernel kills it, even if that thread's process was itself killed.
class ChildProcess {
 public:
  // Throws Error if the log cannot be written or the process cannot be created.
  explicit ChildProcess(const Task& task);
  ~ChildProcess();  // kills its whole group
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  // A descriptor that poll() reports as readable once the process has ended.
  int poll_fd() const { return poll_fd_; }
  // Returns how the process ended, or nothing while it runs. Kills it at the time limit. Whatever
  // is left of its group is killed with it.
  [[nodiscard]] std::optional<TaskEnd> Poll();

 private:
  using Clock = std::chrono::steady_clock;

  void KillGroup() const;
  TaskEnd Reap();
  std::string MessageOf(int status) const;

  Clock::time_point start_;
  double limit_s_;
  double limit_memory_mb_;
  bool timed_out_ = false;
  pid_t process_ = -1;
  int poll_fd_ = -1;
};

}  // namespace cvo
