// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// suite_kills KILLS [SEED]: runs a suite undisturbed, then again and again with that many SIGKILLs
// at random moments, of the runner, of a worker or of all of them, resuming after each. Every file
// of every result, and the table, must be the same bytes.
#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
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
#include "tests/experiments/jobs/wait_until.h"
#include "tests/experiments/runner/tiny_sequence.h"
#include "tests/support/temp_folder.h"

namespace cvo::test {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;
using Files = std::map<std::string, std::string>;  // content by path

constexpr const char* kSuite = R"({
  "name": "kills", "about": "a scene and a folder, a few estimators",
  "sequences": [{"scene": "tiny", "detections": "good"}, {"folder": "wall"}],
  "variants": ["full", "static"], "seeds": 2,
  "table": {"rows": ["variant"], "metrics": ["camera_ate"], "reference": "full"}
})";

// The processes that a runner has at this moment.
std::vector<pid_t> WorkersOf(pid_t runner) {
  std::ifstream in(StrCat("/proc/", runner, "/task/", runner, "/children"));
  std::vector<pid_t> workers;
  for (pid_t worker = 0; in >> worker;) workers.push_back(worker);
  return workers;
}

bool IsGone(pid_t process) {
  std::ifstream in(StrCat("/proc/", process, "/stat"));
  std::string number;
  std::string name;
  std::string state;
  return !(in >> number >> name >> state) || state == "Z";
}

class Suite {
 public:
  explicit Suite(const TempFolder& folder) : folder_(folder.path()) {
    suite_ = folder.Write("suite.json", kSuite).string();
    WriteTinySequence(folder_ / "data" / "wall", 8);
    ::setenv("CLUSTERVO_CACHE", (folder_ / "cache").c_str(), 1);
  }

  fs::path out() const { return folder_ / "out"; }
  fs::path cache() const { return folder_ / "cache"; }

  pid_t Start() const {
    return Start(
        {"run", suite_, "-o", out().string(), "--data", (folder_ / "data").string(), "-j", "2"});
  }
  pid_t StartTable() const { return Start({"table", out().string()}); }
  std::string Log() const { return ReadFile(folder_ / "log"); }

  // Everything that a result consists of; no leftovers are among it.
  Files Results() const {
    Files files;
    for (const char* part : {"jobs", "failed"}) {
      for (const auto& entry : fs::recursive_directory_iterator(out() / part)) {
        const std::string name = entry.path().lexically_relative(out()).string();
        if (!entry.is_regular_file() || name.ends_with("timing.json")) continue;
        files[name] = ReadFile(entry.path());
      }
    }
    for (const char* name : {"plan.json", "table.json"}) files[name] = ReadFile(out() / name);
    return files;
  }

 private:
  // `clustervo experiment ...`
  pid_t Start(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), {CVO_PROGRAM, "experiment"});
    std::vector<char*> argv;
    for (std::string& argument : arguments) argv.push_back(argument.data());
    argv.push_back(nullptr);
    const std::string log = (folder_ / "log").string();
    const pid_t runner = ::fork();
    Require(runner >= 0, "fork");
    if (runner > 0) return runner;
    const int fd = ::open(log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
    ::dup2(fd, STDOUT_FILENO);
    ::dup2(fd, STDERR_FILENO);
    ::execv(argv[0], argv.data());
    ::_exit(126);
  }

  fs::path folder_;
  std::string suite_;
};

// The exit code, 128 + signal where one ended it.
int WaitFor(pid_t runner) {
  int status = 0;
  while (::waitpid(runner, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

bool HasEnded(pid_t runner) {
  siginfo_t info{};
  return ::waitid(P_PID, static_cast<id_t>(runner), &info, WEXITED | WNOHANG | WNOWAIT) == 0 &&
         info.si_pid == runner;
}

enum class KillTarget { kRunner, kWorker, kAll };

class KillTest {
 public:
  KillTest(const TempFolder& folder, std::uint64_t seed) : suite_(folder), rng_(seed, "kills") {}

  void Run(int kills) {
    const auto start = Clock::now();
    const int code = WaitFor(suite_.Start());
    if (code != 0) throw Error(StrCat("exit code ", code, ": ", suite_.Log()));
    const std::chrono::duration<double> undisturbed = Clock::now() - start;
    MakeTable();
    expected_ = suite_.Results();
    std::cout << expected_.size() << " files in " << undisturbed.count() << " s undisturbed\n";
    fs::remove_all(suite_.cache());  // the first round renders under fire
    while (kills_ < kills) {
      fs::remove_all(suite_.out());
      fs::remove_all(suite_.cache() / "frontend");
      Round(kills, 0.5 * undisturbed.count());
      MakeTable();
      Compare();
    }
    std::cout << kills_ << " kills: " << counts_[KillTarget::kRunner] << " of the runner, "
              << counts_[KillTarget::kWorker] << " of a worker, " << counts_[KillTarget::kAll]
              << " of all; every result and the table the same bytes\n";
  }

 private:
  void MakeTable() const {
    const int code = WaitFor(suite_.StartTable());
    if (code != 0) throw Error(StrCat("table: exit code ", code, ": ", suite_.Log()));
  }

  // Until the suite is done, or undisturbed once there were enough kills.
  void Round(int kills, double longest_s) {
    for (;;) {
      const pid_t runner = suite_.Start();
      bool worker_killed = false;
      while (kills_ < kills && !WaitOrEnd(runner, rng_.Uniform(0.0, longest_s))) {
        const KillTarget target = Kill(runner);
        ++kills_;
        ++counts_[target];
        worker_killed = target == KillTarget::kWorker;
        if (!worker_killed) break;
      }
      const int code = WaitFor(runner);
      if (code == 0) return;
      const bool expected = code == 128 + SIGKILL || (code == 1 && worker_killed);
      if (!expected) throw Error(StrCat("exit code ", code, ": ", suite_.Log()));
    }
  }

  // Whether the runner ended before the time was over.
  static bool WaitOrEnd(pid_t runner, double seconds) {
    const auto end = Clock::now() + std::chrono::duration<double>(seconds);
    while (Clock::now() < end && !HasEnded(runner)) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return HasEnded(runner);
  }

  KillTarget Kill(pid_t runner) {
    auto target = static_cast<KillTarget>(rng_.UniformInt(3));
    const std::vector<pid_t> workers = WorkersOf(runner);
    if (workers.empty()) target = KillTarget::kRunner;
    if (target == KillTarget::kWorker) {
      ::kill(workers[rng_.UniformInt(workers.size())], SIGKILL);
      return target;
    }
    ::kill(runner, SIGKILL);
    if (target == KillTarget::kAll) {
      for (const pid_t worker : workers) ::kill(worker, SIGKILL);
    }
    for (const pid_t worker : workers) {
      if (!WaitUntil([worker] { return IsGone(worker); })) throw Error("a worker lives on");
    }
    return target;
  }

  void Compare() const {
    const Files files = suite_.Results();
    for (const auto& [name, content] : expected_) {
      const auto found = files.find(name);
      if (found == files.end()) throw Error(StrCat(name, " is not there"));
      if (found->second != content) throw Error(StrCat(name, " differs"));
    }
    for (const auto& [name, content] : files) {
      if (!expected_.contains(name)) throw Error(StrCat(name, " is too much"));
    }
  }

  Suite suite_;
  Rng rng_;
  Files expected_;
  int kills_ = 0;
  std::map<KillTarget, int> counts_;
};

int Main(int argc, char** argv) {
  const int kills = argc > 1 ? std::atoi(argv[1]) : 0;
  if (kills <= 0) {
    std::cerr << "suite_kills KILLS [SEED]\n";
    return 2;
  }
  const TempFolder folder;
  try {
    KillTest(folder, argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1).Run(kills);
    return 0;
  } catch (const std::exception& error) {
    std::cerr << "suite_kills: " << error.what() << '\n';
    return 1;
  }
}

}  // namespace
}  // namespace cvo::test

int main(int argc, char** argv) { return cvo::test::Main(argc, argv); }
