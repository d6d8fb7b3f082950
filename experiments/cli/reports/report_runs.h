// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace cvo {

// Makes `folder` look as if a suite of these runs, of one sequence, had been run to it. Throws
// Error for a folder without a run, runs of different sequences and the same run twice.
void MakeSuiteOfRuns(const std::vector<std::string>& runs, const std::filesystem::path& folder);

}  // namespace cvo
