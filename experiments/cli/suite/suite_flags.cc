// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/cli/suite/suite_flags.h"

#include <cstdlib>

#include "core/base/error.h"
#include "experiments/cli/command.h"
#include "experiments/cli/run/known_names.h"
#include "experiments/cli/run/run_flags.h"
#include "experiments/jobs/local_engine.h"
#include "experiments/jobs/slurm/slurm_engine.h"
#include "experiments/suite/parse_suite.h"
#include "synth/write/render_cache.h"

namespace cvo {

void SuiteFlags::AddTo(CLI::App& app) {
  app.add_option("SUITE", suite, "a shipped suite (clustervo experiment list) or a suite file")
      ->type_name("")
      ->required();
  app.add_option("-o,--output", output, "output folder of the suite")->type_name("DIR")->required();
  app.add_option("--data", data, "root folder of the real sequences; default: CLUSTERVO_DATA")
      ->type_name("FOLDER");
  app.add_option("--seeds", overrides.seeds, "use seeds 1 to N instead of the suite's")
      ->type_name("N")
      ->check(CLI::Range(1, 10000).description(""));
  app.add_option("--frames", overrides.frames,
                 "use frames A to B-1 of every sequence instead of the suite's")
      ->type_name("A:B");
  app.add_option("--set", overrides.set,
                 "set an option (see clustervo options), an axis of the suite's grid, or, with the "
                 "prefix scene., a value of all scenes; can be repeated")
      ->type_name("PATH=VALUE")
      ->allow_extra_args(false);
}

Suite SuiteFlags::Load() const {
  return LoadNamed(suite, [&] { return Override(LoadSuite(suite), overrides); });
}

PlanRequest SuiteFlags::Request() const {
  PlanRequest request;
  const char* variable = std::getenv("CLUSTERVO_DATA");
  request.data = !data.empty() ? data : variable == nullptr ? "" : variable;
  request.cache = synth::CacheFolder();
  return request;
}

void EngineFlags::AddTo(CLI::App& app) {
  app.add_option("-j,--jobs", jobs,
                 "number of jobs to run in parallel; default: number of CPUs, with slurm all jobs")
      ->type_name("N")
      ->check(CLI::Range(1, 1024).description(""));
  app.add_option(
         "--engine", name,
         "where jobs run: local (processes on this machine) or slurm (see experiments/README.md)")
      ->type_name("NAME")
      ->check(OneOf({"local", "slurm"}))
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
