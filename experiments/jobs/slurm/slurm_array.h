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

// One job array. Its folder holds everything that it needs and writes: array.json, tasks.sh,
// end/<number>, and out/<number> (the output of Slurm itself). Any process that finds the folder
// can follow the array.
struct SlurmArray {
  struct Entry {
    std::string name;  // Task::name
    std::string key;   // TaskKey
  };
  std::filesystem::path folder;
  std::string name;            // Slurm's job name, unique to this array
  std::vector<Entry> entries;  // by task number
};

// How the program of a task ended.
struct SlurmEnd {
  int code = 0;
  double seconds = 0.0;
};

// Returns a key that is equal for tasks that would run the same program in the same way.
std::string TaskKey(const Task& task, const std::vector<std::string>& sbatch_flags);

// Writes the array to a new folder in `root`, which is created if necessary. Throws Error if it
// cannot be written.
SlurmArray WriteSlurmArray(const std::filesystem::path& root, std::span<const Task> tasks,
                           const std::vector<std::string>& sbatch_flags);
// Returns all arrays that earlier runs left in `root`, ordered by folder. A folder that was not
// completely written was never submitted and is removed.
std::vector<SlurmArray> ReadSlurmArrays(const std::filesystem::path& root);

// Returns how the ended tasks ended, by task number. An incomplete file counts as none.
std::map<std::size_t, SlurmEnd> ReadSlurmEnds(const SlurmArray& array);
// Removes the array's folder, which may stay if a node still holds a file in it open.
void RemoveSlurmArray(const SlurmArray& array);

// Returns the last line that Slurm wrote about a task; empty if there is none.
std::string SlurmWords(const SlurmArray& array, std::size_t number);

}  // namespace cvo
