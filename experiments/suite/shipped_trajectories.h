// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/runner/system_files.h"
#include "experiments/suite/suite.h"

namespace cvo {

// Returns an entry for each of the sequences on which the program ships a trajectory of `system`.
// Throws Error at `where` if there is none.
std::vector<SuiteSystem::Files> ShippedFilesOf(const std::string& system,
                                               const std::vector<SuiteSequence>& sequences,
                                               const std::string& where);

// PlannedJob::missing starts with this if a shipped trajectory was made from other images.
inline constexpr std::string_view kStale = "stale: ";

// Writes the trajectory of a sequence from ShippedFilesOf below the cache folder and returns the
// file. Throws Error, with kStale, if the scene file has changed since the trajectory was made, or
// if the sequence uses other frames or perturbed images.
SystemFiles ShippedSystemFiles(const std::string& system, const SuiteSequence& sequence,
                               const std::filesystem::path& cache);

}  // namespace cvo
