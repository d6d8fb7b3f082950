// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/jobs/child_process.h"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <string_view>

#include "core/base/error.h"
#include "core/files/text/number.h"

namespace cvo {
namespace {

constexpr int kCannotExecute = 126;
constexpr int kCannotLoad = 127;  // from the dynamic loader, if its libraries do not fit

[[noreturn]] void ThrowErrno(const std::string& what, const char* action, int error) {
  throw Error(StrCat(what, ": cannot ", action, ": ", std::strerror(error)));
}

// Everything that the child needs, prepared before the fork: between fork and exec it must not
// allocate.
struct Launch {
  std::vector<std::string> argv;
  std::vector<char*> pointers;
  int log = -1;
  int null = -1;
  rlim_t memory_bytes = 0;
  pid_t parent = ::getpid();

  explicit Launch(const Task& task) : argv(task.argv) {
    Require(!argv.empty(), "Task: no program");
    for (std::string& argument : argv) pointers.push_back(argument.data());
    pointers.push_back(nullptr);
    memory_bytes = static_cast<rlim_t>(task.limit_memory_mb * 1e6);
    constexpr int kFlags = O_WRONLY | O_CREAT | O_TRUNC | O_APPEND | O_CLOEXEC;
    log = ::open(task.log.c_str(), kFlags, 0666);
    if (log < 0) ThrowErrno(task.log.string(), "write", errno);
    null = ::open("/dev/null", O_RDONLY | O_CLOEXEC);
  }
  ~Launch() {
    ::close(log);
    if (null >= 0) ::close(null);
  }
  Launch(const Launch&) = delete;
  Launch& operator=(const Launch&) = delete;

  [[noreturn]] void Execute() const {
    ::setpgid(0, 0);
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (::getppid() != parent) ::_exit(kCannotExecute);  // the parent died before prctl
    ::dup2(null, STDIN_FILENO);
    ::dup2(log, STDOUT_FILENO);
    ::dup2(log, STDERR_FILENO);
    if (kLimitsMemory && memory_bytes > 0) {
      const rlimit limit{memory_bytes, memory_bytes};
      ::setrlimit(RLIMIT_AS, &limit);
    }
    ::execv(pointers.front(), pointers.data());
    constexpr std::string_view kMessage = "clustervo: error: the program cannot be executed\n";
    [[maybe_unused]] const ssize_t written =
        ::write(STDERR_FILENO, kMessage.data(), kMessage.size());
    ::_exit(kCannotExecute);
  }
};

std::string SignalText(int signal) {
  const char* name = ::sigabbrev_np(signal);
  return StrCat("killed by signal ", signal, name != nullptr ? StrCat(" (SIG", name, ")") : "");
}

}  // namespace

ChildProcess::ChildProcess(const Task& task)
    : start_(Clock::now()), limit_s_(task.limit_s), limit_memory_mb_(task.limit_memory_mb) {
  const Launch launch(task);
  process_ = ::fork();
  if (process_ < 0) ThrowErrno(task.name, "start a process", errno);
  if (process_ == 0) launch.Execute();
  ::setpgid(process_, process_);  // also done by the child, to avoid a race
  // Called by its system call number: the header of glibc 2.36 declares it without C linkage.
  poll_fd_ = static_cast<int>(::syscall(SYS_pidfd_open, process_, 0));
  if (poll_fd_ >= 0) return;
  const int error = errno;
  KillGroup();
  ::waitpid(process_, nullptr, 0);
  ThrowErrno(task.name, "follow its process", error);
}

ChildProcess::~ChildProcess() {
  if (process_ > 0) {
    KillGroup();
    Reap();
  }
  ::close(poll_fd_);
}

void ChildProcess::KillGroup() const { ::kill(-process_, SIGKILL); }

std::optional<TaskEnd> ChildProcess::Poll() {
  const double seconds = std::chrono::duration<double>(Clock::now() - start_).count();
  if (limit_s_ > 0.0 && seconds >= limit_s_ && !timed_out_) {
    timed_out_ = true;
    KillGroup();
  }
  // WNOWAIT leaves the process unreaped, so that its group id cannot be reused before KillGroup.
  siginfo_t info{};
  if (::waitid(P_PIDFD, static_cast<id_t>(poll_fd_), &info, WEXITED | WNOHANG | WNOWAIT) == 0 &&
      info.si_pid == 0) {
    return std::nullopt;
  }
  KillGroup();
  return Reap();
}

TaskEnd ChildProcess::Reap() {
  int status = 0;
  while (::waitpid(process_, &status, 0) < 0 && errno == EINTR) {
  }
  process_ = -1;
  TaskEnd end;
  end.seconds = std::chrono::duration<double>(Clock::now() - start_).count();
  end.ok = WIFEXITED(status) && WEXITSTATUS(status) == 0;
  if (end.ok) return end;
  end.message = MessageOf(status);
  return end;
}

std::string ChildProcess::MessageOf(int status) const {
  if (!WIFSIGNALED(status)) {
    const bool unloaded = WEXITSTATUS(status) == kCannotLoad && limit_memory_mb_ > 0.0;
    if (!unloaded) return StrCat("exit code ", WEXITSTATUS(status));
    return StrCat("memory limit of ", limit_memory_mb_, " MB: the program alone takes more");
  }
  if (timed_out_) return StrCat("stopped after ", limit_s_, " s");
  const std::string killed = SignalText(WTERMSIG(status));
  // The stack could not grow, or the program does not fit at all.
  if (WTERMSIG(status) != SIGSEGV || limit_memory_mb_ == 0.0) return killed;
  return StrCat(killed, " under a memory limit of ", limit_memory_mb_, " MB");
}

}  // namespace cvo
