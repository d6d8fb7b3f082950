// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "experiments/jobs/engine.h"

namespace cvo {

// One job array. Its folder holds all that it needs and all that it leaves: array.json, tasks.sh,
// end/<number>, out/<number> (what Slurm itself has to say). Whoever finds the folder can follow
// it.
struct SlurmArray {
  struct Entry {
    std::string name;  // Task::name
    std::string key;   // TaskKey
  };
  std::filesystem::path folder;
  std::string name;            // Slurm's name of the job, of this array alone
  std::vector<Entry> entries;  // by number
};

// How a task's program ended.
struct SlurmEnd {
  int code = 0;
  double seconds = 0.0;
};

// Equal where the same thing would be run in the same way.
std::string TaskKey(const Task& task, const std::vector<std::string>& sbatch_flags);

// A new folder in `root`, which is created. Throws Error where it cannot be written.
SlurmArray WriteSlurmArray(const std::filesystem::path& root, std::span<const Task> tasks,
                           const std::vector<std::string>& sbatch_flags);
// All that earlier runs left in `root`, by folder. One that was not written to its end was never
// submitted: it is removed.
std::vector<SlurmArray> ReadSlurmArrays(const std::filesystem::path& root);

// By number, of the tasks that have ended. A file that is not complete counts as none.
std::map<std::size_t, SlurmEnd> ReadSlurmEnds(const SlurmArray& array);
// A file that a node still holds open may keep the folder; then it stays.
void RemoveSlurmArray(const SlurmArray& array);

// The last line that Slurm wrote about a task; empty where there is none.
std::string SlurmWords(const SlurmArray& array, std::size_t number);

}  // namespace cvo
