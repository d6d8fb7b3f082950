// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/suite/engine.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <fstream>
#include <map>

#include "core/base/error.h"
#include "experiments/suite/job_status.h"
#include "tests/experiments/cli/process.h"
#include "tests/support/error_message.h"
#include "tests/support/temp_folder.h"

namespace cvo::engine_test {
namespace {

namespace fs = std::filesystem;
using test::ReadFile;
using test::WaitUntil;
using testing::HasSubstr;

double Seconds(const std::function<void()>& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// A zombie, which has ended but has not been waited for, does not count as alive.
bool IsAlive(pid_t process) {
  std::ifstream in(StrCat("/proc/", process, "/stat"));
  std::string number;
  std::string name;
  std::string state;
  return in >> number >> name >> state && state != "Z";
}

class LocalEngineTest : public testing::Test {
 protected:
  Task Shell(const std::string& name, const std::string& script) const {
    return {.name = name, .argv = {"/bin/sh", "-c", script}, .log = folder_.path() / name};
  }
  // Runs the tasks and returns how each ended, by index.
  std::map<std::size_t, TaskEnd> Run(const std::vector<Task>& tasks, int processes = 1) const {
    std::map<std::size_t, TaskEnd> ends;
    EngineHooks hooks;
    hooks.ended = [&](std::size_t task, const TaskEnd& end) {
      EXPECT_TRUE(ends.emplace(task, end).second);
    };
    LocalEngine(processes).Run(tasks, hooks);
    return ends;
  }
  TaskEnd RunOne(const Task& task) const { return Run({task}).at(0); }
  // A task that writes its process number to the file pid and would run for a minute.
  Task Slow() const {
    return Shell("slow", StrCat("echo $$ > ", folder_.path().string(), "/pid; exec sleep 60"));
  }
  pid_t Pid() const {
    std::ifstream in(folder_.path() / "pid");
    pid_t process = -1;
    in >> process;
    return process;
  }

  test::TempFolder folder_;
};

TEST_F(LocalEngineTest, ReplacesTheLogWithBothStreams) {
  folder_.Write("log", "of the try before, and longer");
  const TaskEnd end = RunOne(Shell("log", "echo out; echo err >&2; cat"));
  EXPECT_TRUE(end.ok);
  EXPECT_EQ(end.message, "");
  EXPECT_EQ(ReadFile(folder_.path() / "log"), "out\nerr\n");
}

TEST_F(LocalEngineTest, ReportsHowAProcessEnded) {
  const TaskEnd code = RunOne(Shell("code", "exit 3"));
  EXPECT_FALSE(code.ok);
  EXPECT_EQ(code.message, "exit code 3");
  EXPECT_EQ(RunOne(Shell("crash", "kill -SEGV $$")).message, "killed by signal 11 (SIGSEGV)");
  EXPECT_EQ(RunOne(Shell("killed", "kill -KILL $$")).message, "killed by signal 9 (SIGKILL)");
}

TEST_F(LocalEngineTest, StopsAProcessAndItsDescendantsAtTheTimeLimit) {
  const std::string parent = StrCat("sleep 60 & echo $! > ", folder_.path().string(), "/pid");
  RunOne(Shell("parent", parent));
  EXPECT_TRUE(WaitUntil([&] { return !IsAlive(Pid()); }));  // although there is no limit
  Task task = Shell("slow", parent + "; wait");
  task.limit_s = 0.3;
  TaskEnd end;
  EXPECT_LT(Seconds([&] { end = RunOne(task); }), 5.0);
  EXPECT_EQ(end.message, "stopped after 0.3 s");
  EXPECT_TRUE(WaitUntil([&] { return !IsAlive(Pid()); }));
}

TEST_F(LocalEngineTest, LimitsTheMemoryOfTheProcess) {
  Task task = Shell("limit", "ulimit -v");
  task.limit_memory_mb = 512.0;
  EXPECT_TRUE(RunOne(task).ok);
  EXPECT_EQ(ReadFile(folder_.path() / "limit"), kLimitsMemory ? "500000\n" : "unlimited\n");  // KiB
}

TEST_F(LocalEngineTest, StartsTasksInOrderUpToTheProcessLimit) {
  // Each task records its presence and exits once there are two of them, or gives up.
  const std::string meet =
      StrCat("cd ", folder_.path().string(), "; touch here.$$; for i in $(seq 100); do ",
             "[ $(ls here.* | wc -l) -ge 2 ] && exit 0; sleep 0.02; done; "
             "exit 1");
  for (const auto& [task, end] : Run({Shell("a", meet), Shell("b", meet)}, 2)) {
    EXPECT_TRUE(end.ok) << task;
  }
  const std::string note = StrCat("echo $0 >> ", folder_.path().string(), "/order");
  std::vector<Task> tasks;
  for (const char* name : {"1", "2", "3", "4"}) {
    tasks.push_back(Shell(name, note));
    tasks.back().argv.emplace_back(name);
  }
  Run(tasks);
  EXPECT_EQ(ReadFile(folder_.path() / "order"), "1\n2\n3\n4\n");
}

TEST_F(LocalEngineTest, StopEndsRunningTasksAndStartsNoMore) {
  EngineHooks hooks;
  hooks.ended = [](std::size_t task, const TaskEnd&) { ADD_FAILURE() << task; };
  hooks.stop = [&] { return Pid() > 0; };
  EXPECT_LT(Seconds([&] {
              LocalEngine(1).Run(std::vector<Task>{Slow(), Shell("next", "true")}, hooks);
            }),
            2.0);
  EXPECT_FALSE(fs::exists(StrCat("/proc/", Pid())));  // reaped as well
  EXPECT_FALSE(fs::exists(folder_.path() / "next"));
}

TEST_F(LocalEngineTest, AThrowingHookLeavesNoProcess) {
  const Task short_one = Shell(
      "short", StrCat("while [ ! -s ", folder_.path().string(), "/pid ]; do sleep 0.02; done"));
  EngineHooks hooks;
  hooks.ended = [](std::size_t, const TaskEnd&) { throw Error("enough"); };
  EXPECT_THROW(LocalEngine(2).Run(std::vector<Task>{Slow(), short_one}, hooks), Error);
  EXPECT_FALSE(IsAlive(Pid()));
}

TEST_F(LocalEngineTest, AnUnwritableLogFailsItsTask) {
  Task task = Shell("none/log", "true");
  const auto ends = Run({task, Shell("good", "true")});
  EXPECT_THAT(ends.at(0).message, HasSubstr("none/log: cannot write: No such file"));
  EXPECT_TRUE(ends.at(1).ok);
}

TEST_F(LocalEngineTest, AnInvalidProgramIsRefused) {
  Task task = Shell("a", "true");
  task.argv.front() = folder_.Write("text", "no program").string();
  EXPECT_THROW(Run({task}), Error);
  ::chmod(task.argv.front().c_str(), 0755);
  EXPECT_EQ(RunOne(task).message, "exit code 126");
  EXPECT_THAT(ReadFile(folder_.path() / "a"), HasSubstr("cannot be executed"));
}

TEST_F(LocalEngineTest, NoProcessOutlivesAKilledEngine) {
  const pid_t runner = ::fork();
  if (runner == 0) {
    EngineHooks hooks;
    hooks.ended = [](std::size_t, const TaskEnd&) {};
    LocalEngine(1).Run(std::vector<Task>{Slow()}, hooks);
    ::_exit(0);
  }
  ASSERT_TRUE(WaitUntil([&] { return Pid() > 0; }));
  ASSERT_TRUE(IsAlive(Pid()));
  ::kill(runner, SIGKILL);
  ::waitpid(runner, nullptr, 0);
  EXPECT_TRUE(WaitUntil([&] { return !IsAlive(Pid()); }));
}

TEST(FolderLock, AdmitsOneProcessAndNamesItUntilItIsKilled) {
  const test::TempFolder folder;
  const auto file = folder.path() / "lock";
  int ready[2];
  ASSERT_EQ(::pipe(ready), 0);
  const pid_t holder = ::fork();
  if (holder == 0) {
    const FolderLock lock(file);
    if (::write(ready[1], "x", 1) == 1) ::pause();
    ::_exit(0);
  }
  // Wait until the child holds the lock: an earlier attempt would take it for a moment, and the
  // child would be refused.
  char byte = 0;
  ASSERT_EQ(::read(ready[0], &byte, 1), 1);
  EXPECT_THAT(
      ErrorMessage([&] { const FolderLock lock(file); }),
      HasSubstr(StrCat(folder.path().string(), ": found in use by process ", holder, " on ")));
  ::kill(holder, SIGKILL);
  ::waitpid(holder, nullptr, 0);
  for (int i = 0; i < 2; ++i) {  // and once more after it is released
    EXPECT_EQ(ErrorMessage([&] { const FolderLock lock(file); }), "");
  }
  EXPECT_THAT(ErrorMessage([] { const FolderLock lock("/proc/none/lock"); }),
              HasSubstr("/proc/none/lock: cannot write: "));
}

}  // namespace
}  // namespace cvo::engine_test
