// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace cvo {

// Makes `folder` look like the output folder of a suite of these runs, which must be on one
// sequence. Throws Error for a folder without a run, for runs on different sequences and for a run
// given twice.
void MakeSuiteOfRuns(const std::vector<std::string>& runs, const std::filesystem::path& folder);

}  // namespace cvo
