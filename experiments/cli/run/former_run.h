// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "experiments/runner/run_job.h"

namespace cvo {

// Throws UsageError if the folder contains the result of a run other than the requested one,
// whichever build made it, or a landmarks.csv that the request does not ask for, because the new
// run would replace them. Reads the images of the sequence only if nothing else distinguishes the
// two runs.
void CheckFormerRun(const RunRequest& request, const std::filesystem::path& folder);

}  // namespace cvo
