// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/suite/engine.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <map>
#include <optional>
#include <string_view>

#include "core/base/error.h"
#include "core/files/atomic_file.h"
#include "experiments/runner/run_files.h"

namespace cvo {

namespace {

using Clock = std::chrono::steady_clock;

constexpr int kPoll_ms = 100;  // interval for checking time limits and `stop`
constexpr int kCannotExecute = 126;
constexpr int kCannotLoad = 127;  // from the dynamic loader, if its libraries do not fit
constexpr std::string_view kNotExecuted = "clustervo: error: the program cannot be executed\n";

// An open file, closed with this object.
struct File {
  int fd;

  explicit File(int opened) : fd(opened) {}
  ~File() {
    if (fd >= 0) ::close(fd);
  }
  File(const File&) = delete;
  File& operator=(const File&) = delete;
};

// What a process is started with.
struct Launch {
  const std::vector<std::string>& argv;
  int out;
  int err;
  double limit_memory_mb = 0.0;
  std::string folder = {};  // where it runs; empty: here
  bool own_group = true;
};

// Starts a program, in its own process group unless told otherwise, without input. The kernel kills
// it when the calling thread ends.
pid_t Start(const Launch& launch) {
  Require(!launch.argv.empty(), "Task: no program");
  const bool in_path = launch.argv.front().find('/') == std::string::npos;
  std::vector<char*> words;
  for (const std::string& word : launch.argv) words.push_back(const_cast<char*>(word.c_str()));
  words.push_back(nullptr);
  const auto bytes = static_cast<rlim_t>(launch.limit_memory_mb * 1e6);
  const File null(::open("/dev/null", O_RDONLY | O_CLOEXEC));
  const pid_t parent = ::getpid();
  const pid_t child = ::fork();
  if (child < 0) ThrowErrno(launch.argv.front(), "start a process", errno);
  if (launch.own_group) ::setpgid(child, child);  // by both processes, to avoid a race
  if (child > 0) return child;
  // Nothing may allocate between fork and exec.
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) ::_exit(kCannotExecute);  // the parent died before prctl
  ::dup2(null.fd, STDIN_FILENO);
  ::dup2(launch.out, STDOUT_FILENO);
  ::dup2(launch.err, STDERR_FILENO);
  if (kLimitsMemory && bytes > 0) {
    const rlimit limit{bytes, bytes};
    ::setrlimit(RLIMIT_AS, &limit);
  }
  if (launch.folder.empty() || ::chdir(launch.folder.c_str()) == 0) {
    (in_path ? ::execvp : ::execv)(words.front(), words.data());
  }
  [[maybe_unused]] const ssize_t written =
      ::write(STDERR_FILENO, kNotExecuted.data(), kNotExecuted.size());
  ::_exit(kCannotExecute);
}

// A process that ends with this object, and its whole group with it.
class ChildProcess {
 public:
  explicit ChildProcess(const Launch& launch)
      : process_(Start(launch)),
        // The header of glibc 2.36 declares pidfd_open without C linkage.
        poll_(static_cast<int>(::syscall(SYS_pidfd_open, process_, 0))) {
    if (poll_.fd >= 0) return;
    const int error = errno;
    KillGroup();
    Reap();
    ThrowErrno(launch.argv.front(), "follow its process", error);
  }
  ~ChildProcess() {
    if (process_ <= 0) return;
    KillGroup();
    Reap();
  }
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  // A descriptor that poll() reports as readable once the process has ended.
  int poll_fd() const { return poll_.fd; }
  void KillGroup() const { ::kill(-process_, SIGKILL); }
  // Returns the status of waitpid, or nothing while the process runs.
  std::optional<int> Poll() {
    // WNOWAIT leaves the process unreaped, so that its group id cannot be reused before KillGroup.
    siginfo_t info{};
    if (::waitid(P_PIDFD, static_cast<id_t>(poll_.fd), &info, WEXITED | WNOHANG | WNOWAIT) == 0 &&
        info.si_pid == 0) {
      return std::nullopt;
    }
    KillGroup();
    return Reap();
  }

 private:
  int Reap() {
    int status = 0;
    while (::waitpid(process_, &status, 0) < 0 && errno == EINTR) {
    }
    process_ = -1;
    return status;
  }

  pid_t process_;
  File poll_;
};

int OpenLog(const std::filesystem::path& log) {
  constexpr int kFlags = O_WRONLY | O_CREAT | O_TRUNC | O_APPEND | O_CLOEXEC;
  const int fd = ::open(log.c_str(), kFlags, 0666);
  if (fd < 0) ThrowErrno(log, "write", errno);
  return fd;
}

// Empty for a program that succeeded.
std::string ProblemOf(int status) {
  if (!WIFSIGNALED(status)) {
    return WEXITSTATUS(status) == 0 ? "" : StrCat("exit code ", WEXITSTATUS(status));
  }
  const int signal = WTERMSIG(status);
  const char* name = ::sigabbrev_np(signal);
  return StrCat("killed by signal ", signal, name != nullptr ? StrCat(" (SIG", name, ")") : "");
}

std::string Contents(int fd) {
  struct stat info {};
  ::fstat(fd, &info);
  std::string text(static_cast<std::size_t>(info.st_size), '\0');
  const ssize_t size = ::pread(fd, text.data(), text.size(), 0);
  text.resize(size > 0 ? static_cast<std::size_t>(size) : 0);
  return text;
}

}  // namespace

Captured Capture(const std::vector<std::string>& argv,
                 const std::function<bool(const Captured&)>& give_up) {
  const File out(::memfd_create("out", MFD_CLOEXEC));
  const File err(::memfd_create("err", MFD_CLOEXEC));
  if (out.fd < 0 || err.fd < 0) ThrowErrno(argv.front(), "keep its output", errno);
  ChildProcess process({argv, out.fd, err.fd});
  for (bool killed = false;;) {
    pollfd ended{process.poll_fd(), POLLIN, 0};
    ::poll(&ended, 1, kPoll_ms);
    const std::optional<int> status = process.Poll();
    Captured captured{0, Contents(out.fd), Contents(err.fd)};
    if (status) {
      if (captured.err == kNotExecuted) throw Error(StrCat("cannot start ", argv.front()));
      captured.exit_code = WIFSIGNALED(*status) ? 128 + WTERMSIG(*status) : WEXITSTATUS(*status);
      return captured;
    }
    if (killed || !give_up(captured)) continue;
    process.KillGroup();
    killed = true;
  }
}

Measured Measure(const std::vector<std::string>& argv, const std::filesystem::path& folder,
                 const std::filesystem::path& log) {
  const File out(OpenLog(log));
  const double cpu_s = CpuSeconds(RUSAGE_CHILDREN);
  const Clock::time_point start = Clock::now();
  const pid_t process = Start({argv, out.fd, out.fd, 0.0, folder.string(), false});
  int status = 0;
  rusage usage{};
  while (::wait4(process, &status, 0, &usage) < 0 && errno == EINTR) {
  }
  return {ProblemOf(status), std::chrono::duration<double>(Clock::now() - start).count(),
          CpuSeconds(RUSAGE_CHILDREN) - cpu_s, static_cast<double>(usage.ru_maxrss) * 1024.0 / 1e6};
}

namespace {

// A task that runs on this machine.
class RunningTask {
 public:
  // Throws Error if the log cannot be written or the process cannot be created.
  explicit RunningTask(const Task& task) : task_(task), process_(Started(task)) {}

  int poll_fd() const { return process_.poll_fd(); }
  // Returns how the task ended, or nothing while it runs. Kills it at its time limit.
  std::optional<TaskEnd> Poll() {
    const double seconds = std::chrono::duration<double>(Clock::now() - start_).count();
    if (task_.limit_s > 0.0 && seconds >= task_.limit_s && !timed_out_) {
      timed_out_ = true;
      process_.KillGroup();
    }
    const std::optional<int> status = process_.Poll();
    if (!status) return std::nullopt;
    return TaskEnd{*status == 0, MessageOf(*status)};
  }

 private:
  static ChildProcess Started(const Task& task) {
    const File log(OpenLog(task.log));
    return ChildProcess({task.argv, log.fd, log.fd, task.limit_memory_mb});
  }
  std::string MessageOf(int status) const {
    const double limit_mb = task_.limit_memory_mb;
    if (!WIFSIGNALED(status)) {
      if (WEXITSTATUS(status) != kCannotLoad || limit_mb == 0.0) {
        return ProblemOf(status);
      }
      return StrCat("memory limit of ", limit_mb, " MB: the program alone takes more");
    }
    if (timed_out_) return StrCat("stopped after ", task_.limit_s, " s");
    // The stack could not grow, or the program does not fit at all.
    if (WTERMSIG(status) != SIGSEGV || limit_mb == 0.0) return ProblemOf(status);
    return StrCat(ProblemOf(status), " under a memory limit of ", limit_mb, " MB");
  }

  const Task& task_;
  Clock::time_point start_ = Clock::now();
  bool timed_out_ = false;
  ChildProcess process_;
};

using Running = std::map<std::size_t, RunningTask>;  // by task index

// Waits until a process ends, a signal arrives, or the poll interval has passed.
void WaitForEvent(const Running& running) {
  std::vector<pollfd> fds;
  for (const auto& [task, process] : running) fds.push_back({process.poll_fd(), POLLIN, 0});
  ::poll(fds.data(), fds.size(), kPoll_ms);
}

void TakeEnded(const EngineHooks& hooks, Running& running) {
  for (auto it = running.begin(); it != running.end();) {
    const std::optional<TaskEnd> end = it->second.Poll();
    const std::size_t task = it->first;
    it = end ? running.erase(it) : std::next(it);
    if (end) hooks.ended(task, *end);
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
      const std::size_t task = next++;
      try {
        running.try_emplace(task, tasks[task]);
      } catch (const Error& error) {
        hooks.ended(task, {false, error.what()});
      }
    }
    if (running.empty()) continue;
    WaitForEvent(running);
    TakeEnded(hooks, running);
  }
}

}  // namespace cvo
