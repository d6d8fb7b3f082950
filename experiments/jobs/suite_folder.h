// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

namespace cvo {

// Layout of the folder that a suite is run to.
struct SuiteFolder {
  std::filesystem::path root;

  std::filesystem::path plan() const { return root / "plan.json"; }
  // Files of a run (RunFileNames). result.json marks a finished job.
  std::filesystem::path job(const std::string& id) const { return root / "jobs" / id; }
  // {"schema_version": 1, "kind": "failure", "job", "message", "log"}: the last try failed.
  std::filesystem::path failure(const std::string& id) const {
    return root / "failed" / (id + ".json");
  }
  std::filesystem::path log(const std::string& name) const {
    return root / "logs" / (name + ".log");
  }
  std::filesystem::path slurm() const { return root / "slurm"; }  // SlurmOptions::folder
  std::filesystem::path lock() const { return root / "lock"; }
};

}  // namespace cvo
