// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/jobs/local_engine.h"

#include <poll.h>
#include <unistd.h>

#include <map>

#include "core/base/error.h"
#include "experiments/jobs/child_process.h"

namespace cvo {
namespace {

constexpr int kPoll_ms = 100;  // interval for checking time limits and `stop`

using Running = std::map<std::size_t, ChildProcess>;  // by task index

void Start(std::span<const Task> tasks, std::size_t task, const EngineHooks& hooks,
           Running& running) {
  try {
    running.try_emplace(task, tasks[task]);
  } catch (const Error& error) {
    hooks.ended(task, {false, error.what(), 0.0});
  }
}

// Waits until a process ends, a signal arrives, or the poll interval has passed.
void WaitForEvent(const Running& running) {
  std::vector<pollfd> fds;
  for (const auto& [task, process] : running) fds.push_back({process.poll_fd(), POLLIN, 0});
  ::poll(fds.data(), fds.size(), kPoll_ms);
}

void TakeEnded(const EngineHooks& hooks, Running& running) {
  for (auto it = running.begin(); it != running.end();) {
    const std::optional<TaskEnd> end = it->second.Poll();
    if (!end) {
      ++it;
      continue;
    }
    const std::size_t task = it->first;
    it = running.erase(it);
    hooks.ended(task, *end);
  }
}

}  // namespace

LocalEngine::LocalEngine(int processes) : processes_(static_cast<std::size_t>(processes)) {
  Require(processes > 0, "LocalEngine: at least one process at once");
}

void LocalEngine::Run(std::span<const Task> tasks, const EngineHooks& hooks) {
  for (const Task& task : tasks) {
    Require(!task.argv.empty(), "Task: no program");
    if (::access(task.argv.front().c_str(), X_OK) != 0) {
      ThrowError(task.argv.front(), "a file that cannot be executed", "a program");
    }
  }
  Running running;
  for (std::size_t next = 0; (next < tasks.size() || !running.empty()) && !hooks.stop();) {
    while (next < tasks.size() && running.size() < processes_ && !hooks.stop()) {
      Start(tasks, next++, hooks, running);
    }
    if (running.empty()) continue;
    WaitForEvent(running);
    TakeEnded(hooks, running);
  }
}

}  // namespace cvo
