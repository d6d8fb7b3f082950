// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

namespace cvo {

// Returns a temporary name for a file or folder that must be either complete under its own name or
// absent. Until it is complete, it has this name beside its target, which identifies the writing
// process: "<folder>/.<name>.tmp-<host>.<process>-<end>".
std::filesystem::path TemporaryName(const std::filesystem::path& target, const std::string& end);

bool IsTemporary(const std::filesystem::path& file);

// Removes temporaries that terminated processes left in a folder. Those from other computers are
// removed when they have not been modified for a day. Never throws.
void RemoveLeftovers(const std::filesystem::path& folder);

// Removes all temporaries in a folder. Only for a caller with exclusive write access to the folder.
void RemoveTemporaries(const std::filesystem::path& folder);

// Removes empty subfolders that have not been modified for a day, such as those of killed tasks.
// Never throws.
void RemoveEmptyFolders(const std::filesystem::path& folder);

}  // namespace cvo
