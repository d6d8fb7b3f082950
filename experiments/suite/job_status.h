// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "experiments/suite/build_plan.h"

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
  // What the placeholders of other systems' commands lead to, by PlanJob::input.
  std::filesystem::path inputs(const std::string& input) const {
    return root / "inputs" / input.substr(0, 16);
  }
  std::filesystem::path slurm() const { return root / "slurm"; }  // SlurmOptions::folder
  std::filesystem::path lock() const { return root / "lock"; }
};

// The exclusive right to write to the folder of a run or suite, held while this object exists and
// the process lives. Others may read meanwhile. The file is removed with the lock.
class FolderLock {
 public:
  // Throws Error saying which process on which host holds the lock, or why the file cannot be
  // created.
  explicit FolderLock(std::filesystem::path file);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  std::filesystem::path file_;
  int fd_ = -1;
};

struct JobStatus {
  enum class State {
    kDone,
    kFailed,      // the last try failed, or the sequence cannot be made or read
    kMissing,     // not run yet, or stopped before it ended
    kNoSequence,  // the user does not have the sequence
  };
  State state = State::kMissing;
  std::string message;  // the reason; empty if done
};

// Returns the status of a job whose input exists, according to its files, whatever wrote them. Only
// a complete result of exactly this job counts; anything else in its place is ignored.
JobStatus StatusOf(const SuiteFolder& folder, const PlanJob& job);

// Returns why the job is not done; empty if it is.
std::string ProblemOfResult(const SuiteFolder& folder, const PlanJob& job);

// Returns one status per job, in the order of the plan. Jobs with the same identity share theirs.
std::vector<JobStatus> StatusOfAll(const SuiteFolder& folder, const Plan& plan);

// Writes failed/<id>.json with the message and the end of the job's log. Throws Error.
void WriteFailure(const SuiteFolder& folder, const std::string& id, const std::string& message);

// Returns the last error line that the program itself wrote to a log, without its prefix; empty if
// there is none.
std::string ErrorInLog(const std::filesystem::path& log);

}  // namespace cvo
