// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/cli/suite/job_report.h"

#include <set>

#include "experiments/jobs/run_plan.h"

namespace cvo {

void PrintJobs(const SuiteFolder& folder, const Plan& plan, const std::vector<JobStatus>& status,
               std::ostream& out) {
  const PlanOutcome counts = CountJobs(status);
  out << status.size() << (status.size() == 1 ? " job: " : " jobs: ") << counts.done << " done";
  if (counts.failed > 0) out << ", " << counts.failed << " failed";
  if (counts.missing > 0) out << ", " << counts.missing << " not run yet";
  if (counts.no_sequence > 0) out << ", " << counts.no_sequence << " with missing input";
  out << '\n';
  std::set<std::string> told;
  for (std::size_t i = 0; i < status.size(); ++i) {
    const PlannedJob& job = plan.jobs[i];
    if (status[i].state == JobStatus::State::kFailed) {
      out << "failed: " << Describe(job.cell) << ": " << status[i].message;
      if (!job.job.empty()) out << " (" << folder.log(job.job).string() << ")";
      out << '\n';
    }
    if (status[i].state == JobStatus::State::kNoSequence &&
        told.insert(job.cell.sequence.name).second) {
      out << "missing input: " << job.cell.sequence.name << ": " << status[i].message << '\n';
    }
  }
}

}  // namespace cvo
