// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// suite_kills KILLS [SEED]: runs a suite undisturbed once, and then repeatedly by two runners at
// the same time, with a folder each and one cache. At random moments a runner, a worker or all of
// them are killed, and started again. Every file of every result, and the tables, must have the
// same bytes as without.
#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <map>
#include <thread>
#include <vector>

#include "core/base/error.h"
#include "core/base/rng.h"
#include "tests/experiments/cli/process.h"
#include "tests/experiments/runner/tiny_sequence.h"
#include "tests/support/temp_folder.h"

namespace cvo::test {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;
using Seconds = std::chrono::duration<double>;
using Files = std::map<std::string, std::string>;  // content by path

constexpr const char* kSuite = R"({
  "name": "kills", "about": "a scene and a folder, a few estimators",
  "sequences": [{"scene": "tiny", "detections": "good"}, {"folder": "wall"}],
  "variants": ["full", "static"], "seeds": 2,
  "table": {"rows": ["variant"], "metrics": ["camera_ate"], "reference": "full"}
})";

// A runner. Which exit codes are allowed depends on what was done to it since it was started.
struct Runner {
  int number = 0;
  pid_t process = 0;  // 0: not running
  bool done = false;
  bool killed = false;
  bool lost_a_worker = false;

  std::vector<pid_t> Workers() const {
    std::ifstream in(StrCat("/proc/", process, "/task/", process, "/children"));
    std::vector<pid_t> workers;
    for (pid_t worker = 0; in >> worker;) workers.push_back(worker);
    return workers;
  }
  bool HasEnded() const {
    siginfo_t info{};
    return ::waitid(P_PID, static_cast<id_t>(process), &info, WEXITED | WNOHANG | WNOWAIT) == 0 &&
           info.si_pid == process;
  }
  void Kill() {
    ::kill(process, SIGKILL);
    killed = true;
  }
};

class KillTest {
 public:
  explicit KillTest(std::uint64_t seed) : rng_(seed, "kills") {
    folder_.Write("suite.json", kSuite);
    WriteTinySequence(folder_.path() / "data" / "wall", 8);
    ::setenv("CLUSTERVO_CACHE", At("cache").c_str(), 1);
  }

  void Run(int kills) {
    const auto start = Clock::now();
    Program(RunArguments(0));
    undisturbed_s_ = Seconds(Clock::now() - start).count();
    const Files expected = Results(0);
    fs::remove_all(At("cache"));  // so that the first round renders while disturbed
    int rounds = 0;
    for (; kills_ < kills; ++rounds) {
      for (const Runner& runner : runners_) fs::remove_all(Out(runner.number));
      Round(kills);
      for (const Runner& runner : runners_) {
        if (Results(runner.number) != expected) {
          throw Error(StrCat("runner ", runner.number, ", round ", rounds, ": other results"));
        }
      }
    }
    std::cout << kills_ << " kills in " << rounds << " rounds: the same bytes\n";
  }

 private:
  std::string At(const std::string& name) const { return (folder_.path() / name).string(); }
  std::string Out(int runner) const { return At(StrCat("out", runner)); }
  std::vector<std::string> RunArguments(int runner) const {
    return {"experiment", "run", At("suite.json"), "-o", Out(runner), "--data", At("data"),
            "-j",         "2"};
  }
  static void Program(const std::vector<std::string>& arguments) {
    const ProcessResult result = RunProgram(arguments);
    if (result.exit_code != 0) throw Error(result.err);
  }

  // Returns every file of the results and the table except times and temporary files.
  Files Results(int runner) const {
    Program({"experiment", "table", Out(runner)});
    Files files;
    for (const auto& entry : fs::recursive_directory_iterator(Out(runner))) {
      const std::string name = entry.path().lexically_relative(Out(runner)).string();
      if (!entry.is_regular_file() || name.ends_with("timing.json") || name.starts_with("lo") ||
          name.find(".tmp-") != std::string::npos) {
        continue;  // "lo": the log and the lock
      }
      files[name] = ReadFile(entry.path());
    }
    return files;
  }

  // Starts a runner whose output goes to a log.
  void Start(Runner& runner) const {
    std::vector<std::string> arguments = RunArguments(runner.number);
    arguments.insert(arguments.begin(), CVO_PROGRAM);
    std::vector<char*> argv;
    for (std::string& argument : arguments) argv.push_back(argument.data());
    argv.push_back(nullptr);
    const std::string log = Log(runner);
    runner = {.number = runner.number, .process = ::fork()};
    Require(runner.process >= 0, "fork");
    if (runner.process > 0) return;
    const int fd = ::open(log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
    ::dup2(fd, STDOUT_FILENO);
    ::dup2(fd, STDERR_FILENO);
    ::execv(argv[0], argv.data());
    ::_exit(126);
  }
  std::string Log(const Runner& runner) const { return At(StrCat("log", runner.number)); }

  // Runs until both runners are done. Kills no more once there were enough.
  void Round(int kills) {
    constexpr double kLongestCalm = 0.2;  // of the undisturbed time of the suite
    for (Runner& runner : runners_) Start(runner);
    while (!runners_[0].done || !runners_[1].done) {
      WaitUntilOneEnds(rng_.Uniform(0.0, kLongestCalm * undisturbed_s_));
      if (kills_ < kills) Kill(runners_[rng_.UniformInt(runners_.size())]);
      for (Runner& runner : runners_) {
        if (runner.done || !(runner.killed || runner.HasEnded())) continue;
        Judge(runner);
        if (!runner.done) Start(runner);
      }
    }
  }
  void WaitUntilOneEnds(double seconds) const {
    const auto end = Clock::now() + Seconds(seconds);
    while (Clock::now() < end) {
      for (const Runner& runner : runners_) {
        if (!runner.done && runner.HasEnded()) return;
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  }

  void Kill(Runner& runner) {
    if (runner.done || runner.HasEnded()) return;
    const std::vector<pid_t> workers = runner.Workers();
    switch (rng_.UniformInt(3)) {
      case 0:
        runner.Kill();
        break;
      case 1:
        if (workers.empty()) return;
        ::kill(workers[rng_.UniformInt(workers.size())], SIGKILL);
        runner.lost_a_worker = true;
        break;
      default:
        for (Runner& other : runners_) {
          if (!other.done) other.Kill();
        }
    }
    ++kills_;
  }

  void Judge(Runner& runner) const {
    int status = 0;
    ::waitpid(runner.process, &status, 0);
    const int code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    const std::string log = ReadFile(Log(runner));
    const bool expected = code == 0 || (code == 128 + SIGKILL && runner.killed) ||
                          (code == 1 && runner.lost_a_worker);
    if (!expected || log.find("internal") != std::string::npos) {
      throw Error(StrCat("runner ", runner.number, ": exit code ", code, ": ", log));
    }
    runner.done = code == 0;
  }

  TempFolder folder_;
  Rng rng_;
  std::array<Runner, 2> runners_ = {Runner{.number = 0}, Runner{.number = 1}};
  double undisturbed_s_ = 0.0;
  int kills_ = 0;
};

int Main(int argc, char** argv) {
  const int kills = argc > 1 ? std::atoi(argv[1]) : 0;
  if (kills <= 0) {
    std::cerr << "suite_kills KILLS [SEED]\n";
    return 2;
  }
  try {
    KillTest(argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1).Run(kills);
    return 0;
  } catch (const std::exception& error) {
    std::cerr << "suite_kills: " << error.what() << '\n';
    return 1;
  }
}

}  // namespace
}  // namespace cvo::test

int main(int argc, char** argv) { return cvo::test::Main(argc, argv); }
