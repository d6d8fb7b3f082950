// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <set>
#include <span>
#include <string>
#include <vector>

namespace cvo {

// One process to run. What it did is judged by the files it leaves, not by the engine.
struct Task {
  std::string name;               // unique among its siblings: the job's identity, or "render ..."
  std::vector<std::string> argv;  // argv[0] is the program's absolute path
  std::filesystem::path log;      // takes standard output and error; replaced
  double limit_s = 0.0;           // wall time; 0: none
  double limit_memory_mb = 0.0;   // address space, 10^6 bytes; 0: none
};

// How a process ended.
struct TaskEnd {
  bool ok = false;      // exit code 0
  std::string message;  // else: "exit code 3", "killed by signal 9", "stopped after 600 s", ...
  double seconds = 0.0;
};

struct EngineHooks {
  // From the thread that called Run, once per task that ended, in any order.
  std::function<void(std::size_t task, const TaskEnd& end)> ended;
  // Asked at least once a second: true ends what runs and starts nothing more.
  std::function<bool()> stop = [] { return false; };
  // One line for the user, such as the id of an array that was submitted.
  std::function<void(const std::string& line)> notice = [](const std::string&) {};
};

// Where tasks run. Order of starting is the order given; a task's bytes never depend on it.
class Engine {
 public:
  virtual ~Engine() = default;

  // Returns when all tasks ended or `stop` did. Throws Error where nothing can be started at all.
  virtual void Run(std::span<const Task> tasks, const EngineHooks& hooks) = 0;

  // Cancels tasks of an earlier process that have none of these names. Tasks with one of them are
  // resumed by Run, which starts none of them a second time.
  virtual void KeepOnly(const std::set<std::string>& /*names*/, const EngineHooks& /*hooks*/) {}

  // How long a file that a task wrote may take to be seen here.
  virtual double latency_s() const { return 0.0; }
};

}  // namespace cvo
