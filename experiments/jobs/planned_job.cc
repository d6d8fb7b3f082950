// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/jobs/planned_job.h"

#include <algorithm>

#include "core/base/error.h"
#include "experiments/files/atomic_file.h"
#include "experiments/jobs/temporaries.h"
#include "experiments/record/build_identity.h"
#include "experiments/runner/run_job.h"
#include "experiments/suite/cell_input.h"
#include "variants/registry.h"

namespace cvo {
namespace {

namespace fs = std::filesystem;

const PlannedJob& FindJob(const Plan& plan, const std::string& id, const SuiteFolder& folder) {
  const auto found = std::find_if(plan.jobs.begin(), plan.jobs.end(),
                                  [&](const PlannedJob& job) { return job.job == id; });
  if (id.empty() || found == plan.jobs.end()) {
    ThrowError(folder.plan().string(), StrCat("no job \"", id, "\""), "a job of the plan");
  }
  return *found;
}

void CheckIdentity(const std::string& found, const std::string& id, const fs::path& sequence) {
  if (found == id) return;
  ThrowError(sequence.string(), "other files than when the plan was made",
             "the same; clustervo experiment run makes a new plan");
}

}  // namespace

void RunPlannedJob(const Plan& plan, const std::string& id, const SuiteFolder& folder) {
  const PlannedJob& job = FindJob(plan, id, folder);
  if (plan.build != ThisBuild().Hash()) {
    ThrowError(folder.plan().string(), "a plan of another build of this program",
               "one of this build; clustervo experiment run makes it");
  }
  const Sequence sequence = OpenSequence(RequestOf(job.cell, job.folder, plan.data));
  const RunRequest request{.sequence = sequence,
                           .variant = FindVariant(job.cell.variant),
                           .options = OptionsOf(plan.suite, job.cell.parameters),
                           .seed = job.cell.seed,
                           .classes = ClassesOf(job.cell.sequence),
                           .oracle = OracleOf(job.cell.oracle)};
  CheckIdentity(IdentifyJob(request), id, sequence.folder);
  const OutputFolder output(folder.job(id), RunFileNames());
  RemoveTemporaries(output.path());
  RemoveTemporaries(output.path() / "clusters");
  const std::optional<JobOutcome> outcome = RunJob(request, output.path());
  const fs::path result = output.path() / "result.json";
  // The bytes that were run on, not those that were looked at before.
  if (outcome->context.job != id) fs::remove(result);
  CheckIdentity(outcome->context.job, id, sequence.folder);
  if (outcome->run.status != RunStatus::kFailed) return;
  fs::remove(result);
  throw Error(outcome->run.message);
}

}  // namespace cvo
