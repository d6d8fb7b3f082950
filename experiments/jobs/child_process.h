// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/types.h>

#include <chrono>
#include <optional>

#include "experiments/jobs/engine.h"

namespace cvo {

// These sanitizers reserve terabytes of addresses, more than any limit on them would leave.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr bool kLimitsMemory = false;
#else
inline constexpr bool kLimitsMemory = true;
#endif

// A task as a process in a group of its own. It does not outlive the thread that started it: the
// system kills it, even where that thread's process was killed itself.
class ChildProcess {
 public:
  // Throws Error where the log cannot be written or no process can be made.
  explicit ChildProcess(const Task& task);
  ~ChildProcess();  // kills its whole group
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  // Readable, as poll has it, once the process ended.
  int poll_fd() const { return poll_fd_; }
  // How it ended; empty while it runs. At the time limit it is killed. What is left of its group
  // ends with it.
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
