// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace cvo {

struct NamedContent {
  std::string name;  // within the folder
  std::string content;
};

// Writes files that belong together: each under a temporary name in the folder, checked and synced
// to the disk; only when all of them are complete are they renamed, the last of the list last.
// Throws Error naming the file and why. A final name holds either what it held before or the
// complete new content, and no temporary is left behind.
void WriteFilesAtomically(const std::filesystem::path& folder,
                          const std::vector<NamedContent>& files);

// Creates the folder where there is none, and proves that files of these names can be written to
// it. Throws Error naming what is in the way.
void PrepareFolder(const std::filesystem::path& folder, const std::vector<std::string>& names);

}  // namespace cvo
