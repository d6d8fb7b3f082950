// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/suite/slurm.h"

#include <gmock/gmock.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <fstream>
#include <map>

#include "core/base/error.h"
#include "experiments/suite/engine.h"
#include "tests/experiments/cli/process.h"
#include "tests/experiments/suite/slurm_cluster.h"
#include "tests/support/error_message.h"

namespace cvo::test::slurm_test {
namespace {

namespace fs = std::filesystem;
using testing::Contains;
using testing::ContainsRegex;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

// What the hooks received during one Run.
struct EngineOutput {
  std::map<std::string, std::vector<TaskEnd>> ends;  // by the task's name
  std::vector<std::string> notices;
};

std::size_t LinesOf(const fs::path& file) {
  std::ifstream in(file);
  std::size_t count = 0;
  for (std::string line; std::getline(in, line);) ++count;
  return count;
}

// Puts a script named `name` in front of the program of that name in PATH, for the lifetime of the
// object.
class Programs {
 public:
  Programs(const std::string& name, const std::string& script) : path_(std::getenv("PATH")) {
    fs::permissions(folder_.Write(name, script), fs::perms::owner_all);
    ::setenv("PATH", StrCat(folder_.path().string(), ":", path_).c_str(), 1);
  }
  ~Programs() { ::setenv("PATH", path_.c_str(), 1); }
  Programs(const Programs&) = delete;
  Programs& operator=(const Programs&) = delete;

  const fs::path& folder() const { return folder_.path(); }

 private:
  TempFolder folder_;
  std::string path_;
};

class SlurmEngineTest : public testing::Test {
 protected:
  SlurmEngineTest() {
    fs::create_directory(folder_);
    options_.folder = folder_ / "slurm";
    options_.poll_s = 0.2;
    options_.latency_s = 1.0;
  }
  void SetUp() override {
    if (!cluster_.missing().empty()) GTEST_SKIP() << cluster_.missing();
  }

  // Returns a task that runs a shell script. Each start appends a line to the file `name`.started.
  Task Shell(const std::string& name, const std::string& script) const {
    Task task;
    task.name = name;
    task.argv = {"/bin/sh", "-c", "echo x >>\"$1\"\n" + script, "sh", Started(name).string()};
    task.log = folder_ / (name + ".log");
    return task;
  }
  fs::path Started(const std::string& name) const { return folder_ / (name + ".started"); }
  std::size_t Starts(const std::string& name) const { return LinesOf(Started(name)); }

  EngineHooks Hooks(const std::vector<Task>& tasks, EngineOutput& output) const {
    EngineHooks hooks;
    hooks.ended = [&](std::size_t task, const TaskEnd& end) {
      output.ends[tasks[task].name].push_back(end);
    };
    hooks.notice = [&](const std::string& line) { output.notices.push_back(line); };
    return hooks;
  }
  EngineOutput RunAll(const std::vector<Task>& tasks) const {
    EngineOutput output;
    SlurmEngine(options_).Run(tasks, Hooks(tasks, output));
    return output;
  }
  // Runs the tasks in a child process that exits when they have ended.
  pid_t StartRunner(const std::vector<Task>& tasks) const {
    const pid_t runner = ::fork();
    if (runner != 0) return runner;
    RunAll(tasks);
    ::_exit(0);
  }
  bool NothingLeft() const { return !fs::exists(options_.folder) || fs::is_empty(options_.folder); }

  TempFolder temp_;
  // Contains the special characters that a shell or Slurm could stumble over.
  fs::path folder_ = temp_.path() / "it's 100%a \"folder\" $HOME";
  SlurmOptions options_;
  SlurmCluster cluster_;
};

std::string Job(const EngineOutput& output) {
  for (const std::string& line : output.notices) {
    if (line.starts_with("slurm: job ")) return line.substr(11, line.find(':', 11) - 11);
  }
  return "";
}

TEST_F(SlurmEngineTest, RunsMoreTasksThanAnArrayHolds) {
  std::vector<Task> tasks;
  for (int i = 0; i < 6; ++i) tasks.push_back(Shell(StrCat("task", i), "true"));
  tasks[1] = Shell("task1", "printf '%s|' \"$@\"; echo to stderr >&2");
  tasks[1].argv.insert(tasks[1].argv.end(), {"it's", "two\nlines", "$HOME `id`", "", "-n", "\\"});
  tasks[2] = Shell("task2", "exit 3");
  tasks[3] = Shell("task3", "sleep 30");
  tasks[3].limit_s = 0.5;
  tasks[4] = Shell("task4", "ulimit -v");
  tasks[4].limit_memory_mb = 512.0;
  tasks[5] = Shell("task5", "kill -9 $$");
  const EngineOutput output = RunAll(tasks);
  ASSERT_EQ(output.ends.size(), tasks.size());
  for (const Task& task : tasks) {
    EXPECT_EQ(output.ends.at(task.name).size(), 1u) << task.name;
    EXPECT_EQ(Starts(task.name), 1u) << task.name;
  }
  EXPECT_TRUE(output.ends.at("task0").front().ok);
  EXPECT_EQ(ReadFile(tasks[1].log),
            tasks[1].argv[4] + "|it's|two\nlines|$HOME `id`||-n|\\|to stderr\n");
  EXPECT_EQ(output.ends.at("task2").front().message, "exit code 3");
  EXPECT_EQ(output.ends.at("task3").front().message, "stopped after 0.5 s");
  EXPECT_TRUE(output.ends.at("task4").front().ok);
  EXPECT_EQ(ReadFile(tasks[4].log), kLimitsMemory ? "500000\n" : "unlimited\n");
  EXPECT_EQ(output.ends.at("task5").front().message, "killed by signal 9 (SIGKILL)");
  EXPECT_THAT(output.notices, ElementsAre(HasSubstr("3 tasks"), HasSubstr("3 tasks")));
  EXPECT_TRUE(NothingLeft());
}

TEST_F(SlurmEngineTest, ATaskWithoutAnExitCodeFailsAlone) {
  const std::vector<Task> tasks = {Shell("cancelled", "sleep 60"), Shell("fine", "true"),
                                   Shell("lost", "kill -9 $PPID")};
  EngineOutput output;
  EngineHooks hooks = Hooks(tasks, output);
  bool done = false;
  hooks.stop = [&] {
    if (!done && Starts("cancelled") == 1) {
      done = true;
      Printed({"scancel", Job(output) + "_0"});
    }
    return false;
  };
  SlurmEngine(options_).Run(tasks, hooks);
  ASSERT_EQ(output.ends.size(), 3u);
  EXPECT_THAT(output.ends["cancelled"].front().message, StartsWith("ended by Slurm: CANCELLED"));
  EXPECT_TRUE(output.ends["fine"].front().ok);
  EXPECT_THAT(output.ends["lost"].front().message, StartsWith("ended by Slurm: FAILED"));
}

TEST_F(SlurmEngineTest, ResumesTheTasksOfAKilledRunner) {
  const std::string wait = "for i in $(seq 300); do [ -e \"${1%/*}/go\" ] || sleep 0.1; done";
  std::vector<Task> tasks;
  for (int i = 0; i < 6; ++i) tasks.push_back(Shell(StrCat("task", i), i == 2 ? "true" : wait));
  const pid_t runner = StartRunner(tasks);
  const bool started = WaitUntil([&] { return Starts("task2") + Starts("task5") == 2; });
  ::kill(runner, SIGKILL);
  ::waitpid(runner, nullptr, 0);
  ASSERT_TRUE(started);
  tasks[1] = Shell("another", "true");  // as if the suite was edited: task1 is no longer requested
  EngineOutput output;
  EngineHooks hooks = Hooks(tasks, output);
  hooks.stop = [&] {
    if (output.ends.contains("another")) std::ofstream(folder_ / "go") << "go";
    return false;
  };
  SlurmEngine engine(options_);
  // Run in two parts: tasks not requested yet must be left alone.
  engine.Run(std::span(tasks).first(3), hooks);
  hooks.ended = [&](std::size_t task, const TaskEnd& end) {
    output.ends[tasks[task + 3].name].push_back(end);
  };
  engine.Run(std::span(tasks).subspan(3), hooks);
  ASSERT_EQ(output.ends.size(), 6u);
  for (const Task& task : tasks) {
    ASSERT_EQ(output.ends[task.name].size(), 1u) << task.name;
    EXPECT_TRUE(output.ends[task.name].front().ok) << output.ends[task.name].front().message;
    EXPECT_EQ(Starts(task.name), 1u) << task.name;
  }
  EXPECT_THAT(output.notices, Contains(HasSubstr("submitted by an earlier run")));
}

TEST_F(SlurmEngineTest, StopCancelsAllTasks) {
  std::vector<Task> tasks;
  for (int i = 0; i < 6; ++i) tasks.push_back(Shell(StrCat("task", i), "sleep 60"));
  EngineOutput output;
  EngineHooks hooks = Hooks(tasks, output);
  hooks.stop = [&] { return Starts("task0") > 0; };
  SlurmEngine(options_).Run(tasks, hooks);
  EXPECT_THAT(output.ends, IsEmpty());
  EXPECT_EQ(Printed({"squeue", "--noheader"}), "");
  EXPECT_TRUE(NothingLeft());
}

TEST_F(SlurmEngineTest, APermanentRefusalIsAnError) {
  const std::vector<Task> tasks = {Shell("task", "true")};
  options_.sbatch_flags = {"--partition=nowhere"};
  EXPECT_THAT(ErrorMessage([&] { RunAll(tasks); }), HasSubstr("partition"));
  EXPECT_TRUE(NothingLeft());
}

TEST(SlurmEngine, GivesUpIfSlurmDoesNotRespond) {
  const std::string unable =
      "#!/bin/sh\necho \"Unable to contact slurm controller (connect failure)\" >&2\nexit 1\n";
  const Programs sbatch("sbatch", unable);
  const Programs squeue("squeue", unable);
  SlurmOptions options;
  options.folder = squeue.folder();
  options.patience_s = 0.5;
  const Task task{"task", {"/bin/true"}, "/dev/null"};
  EXPECT_THAT(ErrorMessage([&] {
                SlurmEngine(options).Run({&task, 1}, {});
              }),
              HasSubstr("Slurm does not respond: squeue: Unable to contact slurm"));
}

TEST(SlurmEngine, AsksTheClustersThatItSubmitsTo) {
  const TempFolder temp;
  const std::string log = (temp.path() / "log").string();
  const auto script = [&](const std::string& name, const std::string& answer) {
    return StrCat("#!/bin/sh\necho ", name, " \"$@\" >>", log, "\n", answer, "\n");
  };
  const Programs sbatch("sbatch", script("sbatch", "echo '7;far'"));
  const Programs scancel("scancel", script("scancel", "touch " + log + ".cancelled"));
  const Programs squeue("squeue",
                        script("squeue",
                               "for a; do case $a in --name=*) name=${a#--name=};; esac; done; "
                               "[ -e " +
                                   log + ".cancelled ] || echo \"$name|7|0|RUNNING\""));
  SlurmOptions options;
  options.folder = temp.path() / "slurm";
  options.sbatch_flags = {"--clusters=far"};
  EngineHooks hooks;
  hooks.stop = [&] { return LinesOf(log) >= 2; };
  const Task task{"task", {"/bin/true"}, "/dev/null"};
  SlurmEngine(options).Run({&task, 1}, hooks);
  for (const char* name : {"sbatch", "squeue", "scancel"}) {
    EXPECT_THAT(ReadFile(log), ContainsRegex(StrCat(name, " [^\n]*--clusters=far"))) << name;
  }
}

TEST(SlurmOptions, RefusesFlagsOfSeveralWords) {
  SlurmOptions options;
  options.sbatch_flags = {"-p", "short"};
  EXPECT_THAT(ErrorMessage([&] { SlurmEngine engine(options); }), HasSubstr("found short"));
}

}  // namespace
}  // namespace cvo::test::slurm_test
