// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/cli/suite/engine_flags.h"

#include "core/base/error.h"
#include "experiments/cli/run/run_flags.h"
#include "experiments/jobs/local_engine.h"
#include "experiments/jobs/slurm_engine.h"

namespace cvo {

void EngineFlags::AddTo(CLI::App& app) {
  app.add_option("-j,--jobs", jobs,
                 "number of jobs to run in parallel; default: number of CPUs, with slurm all jobs")
      ->type_name("N")
      ->check(CLI::Range(1, 1024).description(""));
  app.add_option(
         "--engine", name,
         "where jobs run: local (processes on this machine) or slurm (see experiments/README.md)")
      ->type_name("NAME")
      ->check(CLI::IsMember({"local", "slurm"}).description(""))
      ->capture_default_str();
  app.add_option("--sbatch", sbatch,
                 "with slurm: additional flag for sbatch, such as --sbatch=--partition=short; can "
                 "be repeated")
      ->type_name("FLAG")
      ->allow_extra_args(false);
}

std::unique_ptr<Engine> EngineFlags::Make(const SuiteFolder& folder) const {
  if (name == "slurm") {
    SlurmOptions options;
    options.folder = folder.slurm();
    options.sbatch_flags = sbatch;
    options.at_once = jobs;
    return std::make_unique<SlurmEngine>(options);
  }
  if (!sbatch.empty()) ThrowError("--sbatch", "the local engine", "--engine slurm");
  return std::make_unique<LocalEngine>(jobs > 0 ? jobs : DefaultThreads());
}

}  // namespace cvo
