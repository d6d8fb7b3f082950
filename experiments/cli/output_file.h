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

// What was asked for cannot be, whatever files hold: exit code 2, as for wrong flags.
class UsageError : public Error {
 public:
  using Error::Error;
};

// All places that a command writes to come from here, before it does any work. Each function throws
// UsageError where the place, links resolved, is somebody's sequence or below one, is a folder that
// suites keep their runs in, is one of the folders in `read`, or has a file of `read` under a name
// that would be written. `names` and Errors as OutputFolder.
OutputFolder OpenOutput(const std::filesystem::path& folder, const std::vector<std::string>& names,
                        const std::vector<std::filesystem::path>& read);

// For a file that the user named: WriteOutputFile will be allowed to.
void CheckOutputFile(const std::filesystem::path& file,
                     const std::vector<std::filesystem::path>& read);
// Writes it whole or not at all; makes its folder. Throws Error naming what is in the way.
void WriteOutputFile(const std::filesystem::path& file, const std::string& content,
                     const std::vector<std::filesystem::path>& read);

// For a folder that is to become a sequence, in place of itself: what is above it counts.
void CheckNewSequence(const std::filesystem::path& folder,
                      const std::vector<std::filesystem::path>& read);

// The folders that a sequence is read from.
std::vector<std::filesystem::path> FoldersOf(const Sequence& sequence);

}  // namespace cvo
