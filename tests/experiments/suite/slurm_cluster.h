// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <string>
#include <vector>

#include "tests/support/temp_folder.h"

namespace cvo::test {

// Kills every process of a Slurm with this configuration, daemons and tasks included, when it is
// destroyed or this process ends in any way.
class SlurmGuard {
 public:
  explicit SlurmGuard(const std::filesystem::path& config);
  ~SlurmGuard();
  SlurmGuard(const SlurmGuard&) = delete;
  SlurmGuard& operator=(const SlurmGuard&) = delete;

 private:
  pid_t pid_ = -1;
  int alive_ = -1;  // write end of a pipe; the guard acts when it is closed
};

// A real Slurm on this machine: one node with eight simulated processors, at most four tasks per
// array, and its own folder, ports and key. The constructor sets SLURM_CONF to its configuration.
// The destructor ends everything that runs in it.
class SlurmCluster {
 public:
  SlurmCluster();
  ~SlurmCluster();

  // Why there is no cluster. Empty if it is up.
  const std::string& missing() const { return missing_; }
  const std::string& node() const { return node_; }
  const std::filesystem::path& folder() const { return folder_.path(); }

 private:
  void WriteConfig() const;
  bool WaitUntilReady() const;

  TempFolder folder_;
  SlurmGuard guard_;
  std::string node_;
  std::string missing_;
  bool started_ = false;
};

// Runs a program and returns its standard output. Throws Error if it fails.
std::string Printed(const std::vector<std::string>& argv);

}  // namespace cvo::test
