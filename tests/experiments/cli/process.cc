// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/experiments/cli/process.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <cstdlib>

#include "core/base/error.h"

namespace cvo::test {
namespace {

struct Pipe {
  Pipe() { Require(::pipe(ends.data()) == 0, "pipe"); }
  std::array<int, 2> ends{};
};

[[noreturn]] void Execute(const std::vector<std::string>& arguments, const ProcessSetup& setup,
                          const Pipe& out, const Pipe& err) {
  ::dup2(setup.out.empty() ? out.ends[1] : ::open(setup.out.c_str(), O_WRONLY), STDOUT_FILENO);
  ::dup2(err.ends[1], STDERR_FILENO);
  for (const int end : {out.ends[0], out.ends[1], err.ends[0], err.ends[1]}) ::close(end);
  if (setup.out == "closed") ::close(STDOUT_FILENO);
  for (const std::string& variable : setup.environment) {
    const std::size_t equals = variable.find('=');
    ::setenv(variable.substr(0, equals).c_str(), variable.substr(equals + 1).c_str(), 1);
  }
  if (setup.file_size_limit > 0) {
    const rlimit limit{setup.file_size_limit, setup.file_size_limit};
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  if (setup.address_space_limit > 0) {
    const rlimit limit{setup.address_space_limit, setup.address_space_limit};
    ::setrlimit(RLIMIT_AS, &limit);
  }
  std::vector<char*> argv;
  std::string program = CVO_PROGRAM;
  argv.push_back(program.data());
  std::vector<std::string> copies = arguments;
  for (std::string& argument : copies) argv.push_back(argument.data());
  argv.push_back(nullptr);
  ::execv(program.c_str(), argv.data());
  ::_exit(126);
}

// Appends the bytes that have arrived. Returns false at the end of the stream.
bool ReadSome(int fd, std::string& text) {
  std::array<char, 4096> buffer{};
  const ssize_t count = ::read(fd, buffer.data(), buffer.size());
  if (count > 0) text.append(buffer.data(), static_cast<std::size_t>(count));
  return count > 0;
}

void Collect(pid_t process, const ProcessSetup& setup, const Pipe& out, const Pipe& err,
             ProcessResult& result) {
  std::array<pollfd, 2> streams = {pollfd{out.ends[0], POLLIN, 0}, pollfd{err.ends[0], POLLIN, 0}};
  std::string* const texts[] = {&result.out, &result.err};
  bool interrupted = setup.interrupt_at.empty();
  while (streams[0].fd >= 0 || streams[1].fd >= 0) {
    ::poll(streams.data(), streams.size(), -1);
    for (std::size_t i = 0; i < streams.size(); ++i) {
      if (streams[i].revents != 0 && !ReadSome(streams[i].fd, *texts[i])) streams[i].fd = -1;
    }
    if (!interrupted && result.err.find(setup.interrupt_at) != std::string::npos) {
      ::kill(process, SIGINT);
      interrupted = true;
    }
  }
}

}  // namespace

Arguments With(Arguments first, const Arguments& more) {
  first.insert(first.end(), more.begin(), more.end());
  return first;
}

ProcessResult RunProgram(const Arguments& arguments, const ProcessSetup& setup) {
  const Pipe out;
  const Pipe err;
  const pid_t process = ::fork();
  Require(process >= 0, "fork");
  if (process == 0) Execute(arguments, setup, out, err);
  ::close(out.ends[1]);
  ::close(err.ends[1]);
  ProcessResult result;
  Collect(process, setup, out, err, result);
  ::close(out.ends[0]);
  ::close(err.ends[0]);
  int status = 0;
  ::waitpid(process, &status, 0);
  result.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return result;
}

void ExpectError(const ProcessResult& result, const std::string& text, int exit_code) {
  EXPECT_EQ(result.exit_code, exit_code) << result.err;
  EXPECT_TRUE(result.err.starts_with("clustervo: error: ")) << result.err;
  EXPECT_NE(result.err.find(text), std::string::npos) << result.err;
  EXPECT_EQ(LineCount(result.err), 1U) << result.err;
  EXPECT_EQ(result.out, "");
}

std::size_t LineCount(const std::string& text) {
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

}  // namespace cvo::test
