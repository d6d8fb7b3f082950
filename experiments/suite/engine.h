// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace cvo {

// These sanitizers reserve terabytes of address space, more than any memory limit would leave.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr bool kLimitsMemory = false;
#else
inline constexpr bool kLimitsMemory = true;
#endif

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

  // How long a file written by a task may take to become visible here.
  virtual double latency_s() const { return 0.0; }
};

struct Captured {
  int exit_code = 0;  // 128 + signal number if a signal ended it
  std::string out;
  std::string err;
};

// Runs a short program found in PATH, without input and detached from the terminal's signals.
// `give_up` is called several times a second with the output so far; if it returns true, the
// program is killed. Throws Error if the program cannot be started.
Captured Capture(const std::vector<std::string>& argv,
                 const std::function<bool(const Captured&)>& give_up);

// What one run of a program took.
struct Measured {
  std::string problem;  // how it failed: "exit code 3", "killed by signal 11 (SIGSEGV)"; else empty
  double wall_s = 0.0;
  double cpu_s = 0.0;           // of the program and those that it waited for
  double peak_memory_mb = 0.0;  // 10^6 bytes, of the largest of them
};

// Runs a program in a folder, without input and with its output in `log`, until it ends. It is of
// this process's group and under its limits, and is killed with it. Throws Error if no process can
// be created.
Measured Measure(const std::vector<std::string>& argv, const std::filesystem::path& folder,
                 const std::filesystem::path& log);

// Runs tasks as processes on this machine, at most `processes` at once. No process is left when Run
// returns or throws, or when this process is killed.
class LocalEngine : public Engine {
 public:
  explicit LocalEngine(int processes);

  // A task that cannot be started, or whose log cannot be written, is reported as ended with that
  // message. For a stopped task no hook is called. Throws Error if a task's program is not an
  // executable file.
  void Run(std::span<const Task> tasks, const EngineHooks& hooks) override;

 private:
  std::size_t processes_;
};

}  // namespace cvo
