// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ostream>
#include <vector>

#include "experiments/jobs/job_status.h"

namespace cvo {

// "80 jobs: 76 done, 2 failed, 2 with missing input", then a line for each that failed, with its
// message and log, and for each sequence of which something is not there.
void PrintJobs(const SuiteFolder& folder, const Plan& plan, const std::vector<JobStatus>& status,
               std::ostream& out);

}  // namespace cvo
