// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "experiments/runner/run_job.h"

namespace cvo {

// Throws UsageError where the folder holds the result of another run than the request's, whatever
// build made it, or a landmarks.csv that the request does not ask for: a run would replace them.
// Reads the sequence's images where nothing else tells the two apart.
void CheckFormerRun(const RunRequest& request, const std::filesystem::path& folder);

}  // namespace cvo
