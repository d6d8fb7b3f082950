// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// suite_kills KILLS [SEED [slurm]]: runs a suite undisturbed once, and then repeatedly by two
// concurrent runners with a folder each and one cache. At random moments, a runner, a worker or all
// processes are killed, the disk is full for a while, or all files on it get timestamps from the
// future, as after a clock was set back. Processes that ended are restarted. Every file of every
// result, and the tables, must have the same bytes as without disturbance. `slurm`: the jobs run on
// a Slurm of this program's own, whose controller and node daemon are killed too.
#include <fcntl.h>
#include <sched.h>
#include <sys/mount.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <iostream>
#include <map>
#include <optional>
#include <thread>
#include <vector>

#include "core/base/error.h"
#include "core/base/rng.h"
#include "tests/experiments/jobs/slurm/slurm_cluster.h"
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
constexpr int kRunners = 2;

// Returns the child processes that a runner has at this moment.
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

// A folder on its own in-memory file system of 1 GB, visible only to this program and its children.
// If the system does not permit that, an ordinary folder.
class Disk {
 public:
  Disk() {
    has_own_ = ::unshare(CLONE_NEWNS) == 0 &&
               ::mount(nullptr, "/", nullptr, MS_REC | MS_PRIVATE, nullptr) == 0 &&
               ::mount("tmpfs", folder_.path().c_str(), "tmpfs", 0, "size=1g") == 0;
  }
  ~Disk() {
    if (has_own_) ::umount2(folder_.path().c_str(), MNT_DETACH);
  }
  Disk(const Disk&) = delete;
  Disk& operator=(const Disk&) = delete;

  const TempFolder& folder() const { return folder_; }
  bool CanBeFull() const { return has_own_; }
  // Fills the disk. Other processes write meanwhile, so there may be less left than was reported.
  void Fill() const {
    const int fd = ::open(filler().c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0666);
    Require(fd >= 0, "filler");
    auto size = static_cast<off_t>(fs::space(folder_.path()).available);
    while (size > 0 && ::posix_fallocate(fd, 0, size) != 0) size -= 1 << 20;
    ::close(fd);
  }
  void Empty() const { fs::remove(filler()); }

 private:
  fs::path filler() const { return folder_.path() / "filler"; }

  TempFolder folder_;
  bool has_own_ = false;
};

// The suite in its own folder. Each runner has its own output folder and log.
class Suite {
 public:
  Suite(const fs::path& folder, bool on_slurm) : folder_(folder), on_slurm_(on_slurm) {
    std::ofstream(folder_ / "suite.json") << kSuite;
    WriteTinySequence(folder_ / "data" / "wall", 8);
    ::setenv("CLUSTERVO_CACHE", cache().c_str(), 1);
  }

  fs::path out(int runner) const { return folder_ / StrCat("out", runner); }
  fs::path cache() const { return folder_ / "cache"; }
  // Logs are not on the disk that may be full.
  std::string Log(int runner) const { return ReadFile(log(runner)); }

  pid_t Start(int runner) const {
    std::vector<std::string> run = {
        "run",    (folder_ / "suite.json").string(), "-o", out(runner).string(),
        "--data", (folder_ / "data").string(),       "-j", "2"};
    if (on_slurm_) run.insert(run.end(), {"--engine", "slurm"});
    return Start(runner, std::move(run));
  }
  pid_t StartTable(int runner) const { return Start(runner, {"table", out(runner).string()}); }

  // Returns every file of the results and the tables except timing.json, so that leftovers are
  // found too.
  Files Results(int runner) const {
    Files files;
    for (const char* part : {"jobs", "failed"}) {
      for (const auto& entry : fs::recursive_directory_iterator(out(runner) / part)) {
        const std::string name = entry.path().lexically_relative(out(runner)).string();
        if (!entry.is_regular_file() || name.ends_with("timing.json")) continue;
        files[name] = ReadFile(entry.path());
      }
    }
    for (const char* name : {"plan.json", "table.json"}) {
      files[name] = ReadFile(out(runner) / name);
    }
    return files;
  }

 private:
  fs::path log(int runner) const { return logs_.path() / StrCat("log", runner); }

  // Starts `clustervo experiment` with these arguments.
  pid_t Start(int runner, std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), {CVO_PROGRAM, "experiment"});
    std::vector<char*> argv;
    for (std::string& argument : arguments) argv.push_back(argument.data());
    argv.push_back(nullptr);
    const pid_t started = ::fork();
    Require(started >= 0, "fork");
    if (started > 0) return started;
    const int fd = ::open(log(runner).c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
    ::dup2(fd, STDOUT_FILENO);
    ::dup2(fd, STDERR_FILENO);
    ::execv(argv[0], argv.data());
    ::_exit(126);
  }

  fs::path folder_;
  TempFolder logs_;
  bool on_slurm_ = false;
};

// Waits for a process. Returns its exit code, or 128 + signal if it was killed.
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

// A runner. Which exit codes are allowed depends on what was done to it since it was started.
struct Runner {
  int number = 0;
  pid_t process = 0;  // 0: not running
  bool done = false;
  bool killed = false;
  bool may_fail = false;  // a worker was killed, or a resource was missing
};

class KillTest {
 public:
  KillTest(std::uint64_t seed, bool on_slurm)
      : suite_(disk_.folder().path(), on_slurm), rng_(seed, "kills") {
    if (on_slurm) cluster_.emplace();
    if (on_slurm && !cluster_->missing().empty()) throw Error(cluster_->missing());
    disturbances_ = {{"a runner killed", &KillTest::KillRunner}};
    if (!on_slurm) {  // on Slurm, workers are not children of the runner
      disturbances_.push_back({"a worker killed", &KillTest::KillWorker});
      disturbances_.push_back({"all killed", &KillTest::KillAll});
    }
    disturbances_.push_back({"files from the future", &KillTest::SetClockBack});
    if (disk_.CanBeFull()) disturbances_.push_back({"disk full", &KillTest::FillDisk});
    if (on_slurm) {
      disturbances_.push_back({"Slurm's controller killed", &KillTest::KillController});
      disturbances_.push_back({"Slurm's daemon killed", &KillTest::KillNode});
    }
  }

  void Run(int count) {
    const auto start = Clock::now();
    Finish(suite_.Start(0));
    const std::chrono::duration<double> undisturbed = Clock::now() - start;
    Finish(suite_.StartTable(0));
    expected_ = suite_.Results(0);
    std::cout << expected_.size() << " files in " << undisturbed.count() << " s undisturbed"
              << std::endl;
    fs::remove_all(suite_.cache());  // so that the first round renders while disturbed
    const auto first = Clock::now();
    while (disturbed_ < count) {
      for (int i = 0; i < kRunners; ++i) fs::remove_all(suite_.out(i));
      fs::remove_all(suite_.cache() / "frontend");
      if (++rounds_ % kRoundsOfADrawing == 0) fs::remove_all(suite_.cache());
      Round(count, kLongestCalm * undisturbed.count());
      for (int i = 0; i < kRunners; ++i) {
        Finish(suite_.StartTable(i));
        Compare(i);
      }
      const std::chrono::duration<double> took = Clock::now() - first;
      std::cout << "round " << rounds_ << ": " << disturbed_ << " of " << count << ", "
                << static_cast<int>(took.count()) << " s" << std::endl;
    }
    for (const auto& [what, times] : counts_) std::cout << times << " x " << what << '\n';
    std::cout << rounds_ << " rounds of " << kRunners
              << " runners: every result and table the same bytes\n";
  }

 private:
  static constexpr int kRoundsOfADrawing = 10;
  static constexpr double kLongestCalm = 0.2;  // of the undisturbed time of the suite
  struct Disturbance {
    const char* what = "";
    // Returns false if there was nothing to disturb.
    bool (KillTest::*act)(Runner&) = nullptr;
  };

  void Finish(pid_t process) const {
    if (const int code = WaitFor(process); code != 0) {
      throw Error(StrCat("exit code ", code, ": ", suite_.Log(0)));
    }
  }

  // Runs until the suites of all runners are done. Disturbs no more once the requested number is
  // reached.
  void Round(int count, double longest_s) {
    for (int i = 0; i < kRunners; ++i) runners_[static_cast<std::size_t>(i)] = Runner{.number = i};
    for (;;) {
      for (Runner& runner : runners_) {
        if (!runner.done && runner.process == 0) {
          runner.process = suite_.Start(runner.number);
          runner.killed = runner.may_fail = false;
        }
      }
      const bool disturb = disturbed_ < count;
      WaitUntilAnyEnds(disturb ? rng_.Uniform(0.0, longest_s) : kPatience_s);
      if (cluster_) cluster_->Repair();
      Runner* const victim = &runners_[rng_.UniformInt(kRunners)];
      if (disturb && victim->process != 0 && !HasEnded(victim->process)) Disturb(*victim);
      bool all_done = true;
      for (Runner& runner : runners_) {
        if (runner.process != 0 && (runner.killed || HasEnded(runner.process))) Judge(runner);
        all_done = all_done && runner.done;
      }
      if (all_done) return;
    }
  }

  void Disturb(Runner& runner) {
    const Disturbance& drawn = disturbances_[rng_.UniformInt(disturbances_.size())];
    if (!(this->*drawn.act)(runner)) return;
    ++disturbed_;
    ++counts_[drawn.what];
  }

  void WaitUntilAnyEnds(double seconds) const {
    const auto end = Clock::now() + std::chrono::duration<double>(seconds);
    while (Clock::now() < end) {
      for (const Runner& runner : runners_) {
        if (runner.process != 0 && HasEnded(runner.process)) return;
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  }

  void Judge(Runner& runner) const {
    const int code = WaitFor(runner.process);
    const std::string log = suite_.Log(runner.number);
    const bool expected = code == 0 || (code == 128 + SIGKILL && runner.killed) ||
                          ((code == 1 || code == 2) && runner.may_fail);
    if (!expected || log.find("internal") != std::string::npos) {
      throw Error(StrCat("runner ", runner.number, ": exit code ", code, ": ", log));
    }
    runner.done = code == 0;
    runner.process = 0;
  }

  bool KillRunner(Runner& runner) {
    const std::vector<pid_t> workers = WorkersOf(runner.process);
    ::kill(runner.process, SIGKILL);
    runner.killed = true;
    for (const pid_t worker : workers) {
      if (!WaitUntil([worker] { return IsGone(worker); })) throw Error("a worker lives on");
    }
    return true;
  }
  bool KillWorker(Runner& runner) {
    const std::vector<pid_t> workers = WorkersOf(runner.process);
    if (workers.empty()) return false;
    ::kill(workers[rng_.UniformInt(workers.size())], SIGKILL);
    return runner.may_fail = true;
  }
  bool KillAll(Runner&) {
    for (Runner& runner : runners_) {
      if (runner.process == 0) continue;
      for (const pid_t worker : WorkersOf(runner.process)) ::kill(worker, SIGKILL);
      KillRunner(runner);
    }
    return true;
  }
  // Sets timestamps as if all files had been written before the clock was set back by a day.
  bool SetClockBack(Runner&) {
    std::error_code gone;  // files disappear during the iteration
    fs::recursive_directory_iterator at(disk_.folder().path(), gone);
    for (; !gone && at != fs::recursive_directory_iterator(); at.increment(gone)) {
      std::error_code ignored;
      fs::last_write_time(at->path(), fs::file_time_type::clock::now() + std::chrono::hours(24),
                          ignored);
    }
    return true;
  }
  // Takes away something that all runners need, for up to a second.
  bool Outage(const std::function<void()>& begin, const std::function<void()>& end) {
    begin();
    for (Runner& runner : runners_) runner.may_fail = true;
    std::this_thread::sleep_for(std::chrono::duration<double>(rng_.Uniform(0.0, 1.0)));
    end();
    return true;
  }
  bool FillDisk(Runner&) {
    return Outage([this] { disk_.Fill(); }, [this] { disk_.Empty(); });
  }
  // After a crash, the controller may not know which tasks it had started; those run again.
  bool KillController(Runner&) {
    return Outage([this] { cluster_->KillController(); }, [this] { cluster_->StartController(); });
  }
  bool KillNode(Runner&) {
    return Outage([this] { cluster_->KillNode(); }, [this] { cluster_->StartNode(); });
  }

  void Compare(int runner) const {
    const Files files = suite_.Results(runner);
    for (const auto& [name, content] : expected_) {
      const auto found = files.find(name);
      if (found == files.end()) throw Error(StrCat(name, " is not there"));
      if (found->second != content) throw Error(StrCat(name, " differs"));
    }
    for (const auto& [name, content] : files) {
      if (!expected_.contains(name)) throw Error(StrCat(name, " is too much"));
    }
  }

  static constexpr double kPatience_s = 0.2;
  std::optional<SlurmCluster> cluster_;
  Disk disk_;
  Suite suite_;
  Rng rng_;
  std::vector<Disturbance> disturbances_;
  std::array<Runner, kRunners> runners_;
  Files expected_;
  int disturbed_ = 0;
  int rounds_ = 0;
  std::map<std::string, int> counts_;
};

int Main(int argc, char** argv) {
  const int count = argc > 1 ? std::atoi(argv[1]) : 0;
  const bool on_slurm = argc > 3 && std::string(argv[3]) == "slurm";
  if (count <= 0 || (argc > 3 && !on_slurm)) {
    std::cerr << "suite_kills KILLS [SEED [slurm]]\n";
    return 2;
  }
  try {
    KillTest(argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1, on_slurm).Run(count);
    return 0;
  } catch (const std::exception& error) {
    std::cerr << "suite_kills: " << error.what() << '\n';
    return 1;
  }
}

}  // namespace
}  // namespace cvo::test

int main(int argc, char** argv) { return cvo::test::Main(argc, argv); }
