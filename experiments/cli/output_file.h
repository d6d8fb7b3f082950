// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/files/atomic_file.h"
#include "experiments/datasets/sequence.h"

namespace cvo {

// A request that is impossible whatever the files contain: exit code 2, as for wrong flags.
class UsageError : public Error {
 public:
  using Error::Error;
};

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

}  // namespace cvo
