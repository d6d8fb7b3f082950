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

// The sequences of which there is one; throws Error at `where` if there is none.
std::vector<SuiteSystem::Files> ShippedFilesOf(const std::string& system,
                                               const std::vector<SuiteSequence>& sequences,
                                               const std::string& where);

// PlannedJob::missing of a trajectory that is of other images starts with it.
inline constexpr std::string_view kStale = "stale: ";

// The trajectory of a sequence of ShippedFilesOf, as a file below the cache folder. Throws Error,
// with kStale, where the scene file has changed since, or other images are made of it.
SystemFiles ShippedSystemFiles(const std::string& system, const SuiteSequence& sequence,
                               const std::filesystem::path& cache);

}  // namespace cvo
