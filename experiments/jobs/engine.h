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

// One process to run. Its success is judged by the files that it leaves, not by the engine.
struct Task {
  std::string name;               // unique within one Run: the job's identity, or "render ..."
  std::vector<std::string> argv;  // argv[0] is the program's absolute path
  std::filesystem::path log;      // receives standard output and error; overwritten
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
  // Called from the thread that called Run, once per task that ended, in any order.
  std::function<void(std::size_t task, const TaskEnd& end)> ended;
  // Called at least once a second. If it returns true, running tasks are ended and no more are
  // started.
  std::function<bool()> stop = [] { return false; };
  // Receives one line for the user, such as the id of a submitted array.
  std::function<void(const std::string& line)> notice = [](const std::string&) {};
};

// Runs tasks. They start in the order given; the bytes that a task writes never depend on it.
class Engine {
 public:
  virtual ~Engine() = default;

  // Returns when all tasks have ended, or after `stop` returned true. Throws Error if nothing can
  // be started at all.
  virtual void Run(std::span<const Task> tasks, const EngineHooks& hooks) = 0;

  // Cancels tasks of an earlier process whose names are not among these. Tasks whose names are
  // among them are resumed by Run, which does not start them again.
  virtual void KeepOnly(const std::set<std::string>& /*names*/, const EngineHooks& /*hooks*/) {}

  // How long a file written by a task may take to become visible here.
  virtual double latency_s() const { return 0.0; }
};

}  // namespace cvo
