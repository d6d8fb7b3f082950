// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

namespace cvo {

// What is written is complete under its own name or not there: until it is complete it lies beside
// its target, and its name says which process writes it:
// "<folder>/.<name>.tmp-<host>.<process>-<end>".
std::filesystem::path TemporaryName(const std::filesystem::path& target, const std::string& end);

bool IsTemporary(const std::filesystem::path& file);

// Removes what processes that ended left in a folder: those of this computer; those of others once
// a day has passed since the last sign of life. Never throws.
void RemoveLeftovers(const std::filesystem::path& folder);

// Removes all of them: for whoever alone may write to the folder.
void RemoveTemporaries(const std::filesystem::path& folder);

// Removes the empty folders in a folder that nothing was done with for a day, as those of tasks
// that were killed. Never throws.
void RemoveEmptyFolders(const std::filesystem::path& folder);

}  // namespace cvo
