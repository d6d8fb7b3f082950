// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/jobs/planned_job.h"

#include <algorithm>
#include <system_error>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "core/files/atomic_file.h"
#include "core/files/temporary.h"
#include "experiments/cache/content_hash.h"
#include "experiments/record/build_identity.h"
#include "experiments/runner/run_job.h"
#include "experiments/runner/score_files.h"
#include "experiments/suite/cell_input.h"
#include "experiments/suite/plan/scenes.h"
#include "variants/registry.h"

namespace cvo {
namespace {

namespace fs = std::filesystem;

const PlannedJob& FindJob(const Plan& plan, const std::string& id, const SuiteFolder& folder) {
  const PlannedJob* found = FindBy(plan.jobs, &PlannedJob::job, id);
  if (id.empty() || found == nullptr) {
    ThrowError(folder.plan().string(), StrCat("no job \"", id, "\""), "a job of the plan");
  }
  if (plan.build != ThisBuild().identity) {
    ThrowError(folder.plan().string(), "a plan made by another build of this program",
               "one made by this build, see clustervo experiment run");
  }
  return *found;
}

// The folder for the job's files, cleared of temporary files from killed tries.
class JobFolder {
 public:
  JobFolder(const SuiteFolder& folder, const std::string& id)
      : id_(id), output_(folder.job(id), RunFileNames()) {
    RemoveTemporaries(path());
    RemoveTemporaries(path() / "clusters");
  }

  const fs::path& path() const { return output_.path(); }

  // Throws Error if the identity of the job as run differs from the planned one.
  void CheckIdentity(const std::string& made, const Sequence& sequence) const {
    if (made == id_) return;
    RemoveResult();
    ThrowError(sequence.folder.string(),
               StrCat("files or processor level that differ from when the suite was planned (",
                      ThisBuild().cpu_level, " here)"),
               "no change since planning; clustervo experiment run makes a new plan");
  }
  void RemoveResult() const {
    std::error_code ignored;  // a result of another identity does not count anyway
    fs::remove(path() / "result.json", ignored);
  }

 private:
  std::string id_;
  OutputFolder output_;
};

void RunVariant(const Plan& plan, const Cell& cell, const Sequence& sequence, const JobCache& cache,
                const JobFolder& folder) {
  RunRequest request{.sequence = sequence,
                     .variant = FindVariant(cell.variant),
                     .options = OptionsOf(plan.suite, cell.variant, cell.parameters),
                     .seed = cell.seed,
                     .threads = std::max(plan.suite.timed_threads, 1),
                     .classes = ClassesOf(cell.sequence),
                     .oracle = OracleOf(cell.oracle),
                     .landmarks = cell.landmarks};
  if (plan.suite.timed_threads > 0) {
    // A timed job extracts its features itself, so that they count in its time.
    request.images = cache.ImagesOf(sequence, request.threads);
  } else {
    cache.Serve(request);
  }
  folder.CheckIdentity(IdentifyJob(request), sequence);
  const std::optional<JobOutcome> outcome = RunJob(request, folder.path());
  // The identity of the bytes that were processed, which may have changed since the first check.
  folder.CheckIdentity(outcome->context.job, sequence);
  if (outcome->run.status != RunStatus::kFailed) return;
  folder.RemoveResult();
  throw Error(outcome->run.message);
}

void RunSystem(const Plan& plan, const Cell& cell, const Sequence& sequence, const JobCache& cache,
               const JobFolder& folder) {
  const SystemRequest request{.sequence = sequence,
                              .content = ContentHash(sequence, cache.ImagesOf(sequence, 1)),
                              .files = SystemFilesOf(plan.suite, cell, plan.data, cache.folder()),
                              .seed = cell.seed};
  folder.CheckIdentity(IdentifySystem(request), sequence);
  ScoreSystem(request, folder.path());
}

}  // namespace

void RunPlannedJob(const Plan& plan, const std::string& id, const SuiteFolder& folder,
                   const JobCache& cache) {
  const PlannedJob& job = FindJob(plan, id, folder);
  const Sequence sequence = OpenSequence(RequestOf(job.cell, job.folder, plan.data, job.boxes));
  RequireAsRendered(sequence, [&](const auto& files) { return cache.HashesOf(files, 1); });
  const JobFolder output(folder, id);
  (job.cell.system.empty() ? RunVariant : RunSystem)(plan, job.cell, sequence, cache, output);
}

}  // namespace cvo
