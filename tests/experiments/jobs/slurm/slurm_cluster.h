// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <string>
#include <vector>

#include "tests/support/temp_folder.h"

namespace cvo::test {

// A program that ends with this one, however this one ends.
class Daemon {
 public:
  Daemon(const std::vector<std::string>& argv, const std::filesystem::path& log);
  ~Daemon();
  Daemon(Daemon&& other) noexcept;
  Daemon& operator=(Daemon&&) = delete;

  // Until it ends by itself.
  void Await();

 private:
  pid_t pid_ = -1;
};

// Ends what is left of a Slurm with this configuration, tasks and all, when it is destroyed or this
// program has ended in any way.
class SlurmGuard {
 public:
  explicit SlurmGuard(const std::filesystem::path& config);
  ~SlurmGuard();
  SlurmGuard(const SlurmGuard&) = delete;
  SlurmGuard& operator=(const SlurmGuard&) = delete;

 private:
  pid_t pid_ = -1;
  int alive_ = -1;  // the guard sees it closed
};

// A real Slurm on this machine, of one node with eight pretended processors, four tasks to an
// array, and its own folder, ports and key. SLURM_CONF points to it. Ends what runs in it.
class SlurmCluster {
 public:
  SlurmCluster();
  ~SlurmCluster();

  // Why there is no cluster; empty: it is up.
  const std::string& missing() const { return missing_; }
  const std::string& node() const { return node_; }
  const std::filesystem::path& folder() const { return folder_.path(); }

  void StartController();
  // Slurm writes its state down first: after a crash it may not know what it had started.
  void StopController();
  void KillController();
  // The daemon of the node; tasks that it has started go on without it.
  void StartNode();
  void KillNode();

 private:
  void WriteConfig() const;
  bool WaitUntilReady() const;

  TempFolder folder_;
  SlurmGuard guard_;
  std::string node_;
  std::string missing_;
  std::vector<Daemon> munge_;       // munged
  std::vector<Daemon> controller_;  // slurmctld; empty: it is down
  std::vector<Daemon> daemon_;      // slurmd; empty: it is down
};

// What a program printed. Throws Error where it fails.
std::string Printed(const std::vector<std::string>& argv);

}  // namespace cvo::test
