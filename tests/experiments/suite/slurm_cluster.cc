// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/experiments/suite/slurm_cluster.h"

#include <fcntl.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <csignal>
#include <fstream>
#include <thread>

#include "core/base/error.h"
#include "experiments/suite/engine.h"

namespace cvo::test {
namespace fs = std::filesystem;
namespace {

using std::chrono::milliseconds;

constexpr int kTries = 150;  // of 100 ms each: 15 s for Slurm to start, or for its queue to empty

// Searches the folders in which Debian installs Slurm, which may be missing from the user's PATH.
// Returns "" if the program is not found.
std::string ProgramPath(const std::string& name) {
  for (const char* folder : {"/usr/sbin/", "/usr/bin/", "/usr/local/sbin/", "/usr/local/bin/"}) {
    if (::access((folder + name).c_str(), X_OK) == 0) return folder + name;
  }
  return "";
}

std::string ReasonUnavailable() {
  if (::geteuid() != 0) return "Slurm starts as root only";
  for (const char* name : {"munged", "slurmctld", "slurmd", "sbatch", "squeue", "scontrol"}) {
    if (ProgramPath(name).empty()) return StrCat("no ", name, ": install slurm-wlm and munge");
  }
  return "";
}

std::string ShortHostName() {
  std::array<char, 256> name{};
  Require(::gethostname(name.data(), name.size() - 1) == 0, "gethostname");
  const std::string full = name.data();
  return full.substr(0, full.find('.'));
}

// Returns two distinct ports that are free at this moment. Both sockets stay open until both ports
// are known, so that the ports differ.
std::array<int, 2> FreePorts() {
  std::array<int, 2> sockets{};
  std::array<int, 2> ports{};
  for (std::size_t i = 0; i < ports.size(); ++i) {
    sockets[i] = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof(address);
    Require(::bind(sockets[i], reinterpret_cast<sockaddr*>(&address), size) == 0, "bind");
    Require(::getsockname(sockets[i], reinterpret_cast<sockaddr*>(&address), &size) == 0, "port");
    ports[i] = ntohs(address.sin_port);
  }
  for (const int socket : sockets) ::close(socket);
  return ports;
}

// Kills all processes with this variable in their environment: everything that Slurm starts
// inherits SLURM_CONF. Returns false if there are none.
bool KillAllWith(const std::string& variable) {
  bool found = false;
  for (const fs::directory_entry& entry : fs::directory_iterator("/proc")) {
    const std::string pid = entry.path().filename().string();
    if (pid.find_first_not_of("0123456789") != std::string::npos) continue;
    std::ifstream file(entry.path() / "environ");
    for (std::string word; std::getline(file, word, '\0');) {
      if (word != variable) continue;
      found = true;
      ::kill(std::stoi(pid), SIGKILL);
    }
  }
  return found;
}

// Starts a process that the guard ends. Its output goes to <folder>/<program>.out.
void StartDaemon(const fs::path& folder, const std::string& program,
                 std::vector<std::string> flags) {
  std::string path = ProgramPath(program);
  std::vector<char*> pointers = {path.data()};
  for (std::string& flag : flags) pointers.push_back(flag.data());
  pointers.push_back(nullptr);
  const std::string log = (folder / (program + ".out")).string();
  const pid_t pid = ::fork();
  Require(pid >= 0, "fork");
  if (pid > 0) return;
  const int out = ::open(log.c_str(), O_WRONLY | O_CREAT | O_APPEND, 0600);
  ::dup2(out, STDOUT_FILENO);
  ::dup2(out, STDERR_FILENO);
  ::execv(pointers.front(), pointers.data());
  ::_exit(126);
}

Captured Run(const std::vector<std::string>& argv) {
  return Capture(argv, [](const Captured&) { return false; });
}

}  // namespace

// The cluster sets SLURM_CONF only after this fork, so neither this process nor the guard has the
// variable in its initial environment.
SlurmGuard::SlurmGuard(const fs::path& config) {
  std::array<int, 2> ends{};
  Require(::pipe2(ends.data(), O_CLOEXEC) == 0, "pipe");
  pid_ = ::fork();
  Require(pid_ >= 0, "fork");
  if (pid_ == 0) {
    ::setpgid(0, 0);
    ::close(ends[1]);
    char byte = 0;
    while (::read(ends[0], &byte, 1) < 0) {
    }
    // Repeat, to catch processes started in the meantime. It terminates because a zombie has no
    // environment.
    while (KillAllWith("SLURM_CONF=" + config.string())) {
    }
    ::_exit(0);
  }
  ::close(ends[0]);
  alive_ = ends[1];
}

SlurmGuard::~SlurmGuard() {
  ::close(alive_);
  ::waitpid(pid_, nullptr, 0);
}

std::string Printed(const std::vector<std::string>& argv) {
  const Captured captured = Run(argv);
  if (captured.exit_code != 0) throw Error(StrCat(argv.front(), ": ", captured.err));
  return captured.out;
}

SlurmCluster::SlurmCluster()
    : guard_(folder_.path() / "slurm.conf"), node_(ShortHostName()), missing_(ReasonUnavailable()) {
  if (!missing_.empty()) return;
  WriteConfig();
  ::setenv("SLURM_CONF", (folder() / "slurm.conf").c_str(), 1);
  const std::string munge = (folder() / "munge").string();
  started_ = true;
  StartDaemon(folder(), "munged",
              {"--foreground", "--force", "--key-file=" + munge + "/key",
               "--socket=" + munge + "/socket", "--pid-file=" + munge + "/pid",
               "--log-file=" + munge + "/log", "--seed-file=" + munge + "/seed"});
  for (int i = 0; i < kTries && !fs::exists(munge + "/socket"); ++i) {
    std::this_thread::sleep_for(milliseconds(100));
  }
  for (const char* program : {"slurmctld", "slurmd"}) StartDaemon(folder(), program, {"-D"});
  if (!WaitUntilReady()) missing_ = "Slurm does not come up: " + ReadFile(folder() / "slurmd.out");
}

SlurmCluster::~SlurmCluster() {
  if (!started_) return;
  Run({"scancel", StrCat("--user=", ::geteuid())});
  for (int i = 0; i < kTries; ++i) {
    const Captured queue = Run({"squeue", "--noheader"});
    if (queue.exit_code != 0 || queue.out.empty()) break;
    std::this_thread::sleep_for(milliseconds(100));
  }
}

void SlurmCluster::WriteConfig() const {
  for (const char* name : {"munge", "state", "spool"}) {
    fs::create_directory(folder() / name);
    fs::permissions(folder() / name, fs::perms::owner_all);
  }
  std::string key(1024, '\0');
  std::ifstream("/dev/urandom").read(key.data(), 1024);
  fs::permissions(folder_.Write("munge/key", key), fs::perms::owner_read | fs::perms::owner_write);
  const std::array<int, 2> ports = FreePorts();
  const std::string in = folder().string();
  folder_.Write(
      "slurm.conf",
      StrCat("ClusterName=test\nSlurmctldHost=", node_, "(127.0.0.1)\nNodeName=", node_,
             " NodeAddr=127.0.0.1 CPUs=8 RealMemory=16000\n",
             "PartitionName=main Nodes=ALL Default=YES DefMemPerCPU=100\n",
             "SlurmUser=root\nSlurmdUser=root\nSlurmctldPort=", ports[0], "\nSlurmdPort=", ports[1],
             "\nAuthType=auth/munge\nAuthInfo=socket=", in, "/munge/socket\nCredType=cred/munge\n",
             "StateSaveLocation=", in, "/state\nSlurmdSpoolDir=", in, "/spool\n",
             "SlurmctldPidFile=", in, "/slurmctld.pid\nSlurmdPidFile=", in, "/slurmd.pid\n",
             "ProctrackType=proctrack/linuxproc\nTaskPlugin=task/none\n",
             "SelectType=select/cons_tres\nSelectTypeParameters=CR_CPU_Memory\n",
             "JobAcctGatherType=jobacct_gather/none\nMpiDefault=none\nReturnToService=2\n",
             "AccountingStorageType=accounting_storage/none\nSlurmdParameters=config_overrides\n",
             "SchedulerParameters=sched_interval=1,batch_sched_delay=0\nMaxArraySize=4\n",
             "KillWait=1\n"));
}

bool SlurmCluster::WaitUntilReady() const {
  for (int i = 0; i < kTries; ++i) {
    if (Run({"sinfo", "--noheader", "--format=%T"}).out == "idle\n") return true;
    std::this_thread::sleep_for(milliseconds(100));
  }
  return false;
}

}  // namespace cvo::test
