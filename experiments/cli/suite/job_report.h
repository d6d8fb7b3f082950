// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ostream>
#include <vector>

#include "experiments/jobs/job_status.h"

namespace cvo {

// Prints "80 jobs: 76 done, 2 failed, 2 with missing input", then a line for each failed job, with
// its message and log, and for each sequence with missing input.
void PrintJobs(const SuiteFolder& folder, const Plan& plan, const std::vector<JobStatus>& status,
               std::ostream& out);

}  // namespace cvo
