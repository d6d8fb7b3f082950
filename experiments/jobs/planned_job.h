// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "experiments/jobs/suite_folder.h"
#include "experiments/runner/job_cache.h"
#include "experiments/suite/plan/plan.h"

namespace cvo {

// Runs one job of the plan, on one thread unless the suite sets timed_threads, and writes its
// files, result.json last. Throws Error if there is no such job, if the program or the sequence's
// files differ from those planned, or if the estimator failed; then there is no result.
void RunPlannedJob(const Plan& plan, const std::string& id, const SuiteFolder& folder,
                   const JobCache& cache);

}  // namespace cvo
