// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/files/atomic_file.h"
#include "experiments/cli/command.h"
#include "experiments/datasets/sequence.h"

namespace cvo {

// Every command obtains the places it writes to from these functions, before it does any work. Each
// function throws UsageError if the place, with links resolved, is a sequence or lies in one, lies
// in a folder where a suite keeps its runs, is one of the folders in `read`, or contains a file of
// `read` under a name that would be written. `names` and errors are those of OutputFolder.
OutputFolder OpenOutput(const std::filesystem::path& folder, const std::vector<std::string>& names,
                        const std::vector<std::filesystem::path>& read);

// For a file that the user named: checks that WriteOutputFile will be allowed to write it.
void CheckOutputFile(const std::filesystem::path& file,
                     const std::vector<std::filesystem::path>& read);
// Writes the file completely or not at all, and creates its folder if necessary. Throws Error
// naming what is in the way.
void WriteOutputFile(const std::filesystem::path& file, const std::string& content,
                     const std::vector<std::filesystem::path>& read);

// For a folder that will become a sequence. It may replace a sequence, but not lie in one.
void CheckNewSequence(const std::filesystem::path& folder,
                      const std::vector<std::filesystem::path>& read);

// The folders from which a sequence is read.
std::vector<std::filesystem::path> FoldersOf(const Sequence& sequence);

// Checks that OpenOutput cannot make: whether an output would be mixed with other results or with
// the user's own files. The first three throw UsageError, before any work is done.

// Throws if the output is, lies in or contains a folder of `inputs`, or is the folder of a file of
// `inputs`. Paths that are empty or do not exist are ignored.
void CheckApartFrom(const std::vector<std::filesystem::path>& inputs,
                    const std::filesystem::path& output);

// For the output of a run: throws if it is the folder of a suite or lies in the folder of another
// run.
void CheckPlaceOfRun(const std::filesystem::path& output);

// For the output of a suite: throws if it is the folder of a run or of a suite with another name. A
// plan.json that cannot be read counts as none.
void CheckPlaceOfSuite(const std::filesystem::path& output, const std::string& suite);

// For a folder that is read as a suite's folder: throws Error if it contains the suites of a
// collection instead.
void CheckNoCollection(const std::filesystem::path& folder);

// A new folder in the system's folder for temporary files, removed by the destructor. The
// constructor also removes the folders of killed processes. Throws Error if the folder cannot be
// created.
class ScratchFolder {
 public:
  ScratchFolder();
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace cvo
