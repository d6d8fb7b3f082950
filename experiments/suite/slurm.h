// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "core/files/json/json_record.h"
#include "experiments/suite/engine.h"

namespace cvo {

struct SlurmOptions {
  std::filesystem::path folder;           // for the engine alone; absolute, visible to all machines
  std::vector<std::string> sbatch_flags;  // for every task, one word each: "--partition=short"
  int at_once = 0;                        // maximum number of running tasks; 0: decided by Slurm
  double poll_s = 10.0;                   // between queries of the queue; shorter at the start
  double patience_s = 1800.0;             // how long Run waits for an unresponsive Slurm
  double latency_s = 30.0;  // until a file written by one machine is visible to another
};

// Runs tasks as job arrays of Slurm. Every submission is recorded in the folder. If Run is killed
// and called again, tasks that still wait or run are followed, and tasks that succeeded meanwhile
// are reported as ended; nothing is submitted twice. If Slurm stays unresponsive, Run throws and
// its tasks continue. `stop` cancels everything recorded in the folder.
class SlurmEngine : public Engine {
 public:
  // Throws Error for a flag of several words.
  explicit SlurmEngine(SlurmOptions options);

  void Run(std::span<const Task> tasks, const EngineHooks& hooks) override;
  double latency_s() const override { return options_.latency_s; }

 private:
  SlurmOptions options_;
};

// One job array. Its folder holds everything that it needs and writes: array.json, tasks.sh,
// end/<number>, and out/<number> (the output of Slurm itself). Any process that finds the folder
// can follow the array.
struct SlurmArray {
  static constexpr int kSchemaVersion = 2;
  static constexpr const char* kKind = "slurm_array";
  std::filesystem::path folder;
  std::string name;                // Slurm's job name, unique to this array
  std::vector<std::string> tasks;  // Task::name by task number

  CVO_FIELDS(name, tasks);
};

// Writes the array to a new folder in `root`, which is created if necessary. Throws Error if it
// cannot be written.
SlurmArray WriteSlurmArray(const std::filesystem::path& root, std::span<const Task> tasks);
// Returns all arrays that earlier runs left in `root`, ordered by folder. A folder that was not
// completely written was never submitted and is removed.
std::vector<SlurmArray> ReadSlurmArrays(const std::filesystem::path& root);
// Removes the array's folder, which may stay if a node still holds a file in it open.
void RemoveSlurmArray(const SlurmArray& array);
// A text as one word of a POSIX shell, whatever bytes it contains.
std::string ShellQuoted(const std::string& text);

// What the script of a task wrote when the task had ended.
struct SlurmEnd {
  int code = 0;
  double seconds = 0.0;
};
// By task number. An incomplete file counts as none.
std::map<std::size_t, SlurmEnd> ReadSlurmEnds(const SlurmArray& array);
TaskEnd EndByCode(const Task& task, const SlurmEnd& end);
// Returns how a task ended that was ended by Slurm ("CANCELLED", "TIMEOUT", ...), or that left the
// queue without a state (`state` is empty).
TaskEnd EndByState(const SlurmArray& array, std::size_t number, const std::string& state);

}  // namespace cvo
