// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <memory>

#include "experiments/cli/command.h"
#include "experiments/cli/run/run_flags.h"
#include "experiments/cli/suite/run_collection.h"

namespace cvo {

Command AddExperimentRunCommand(CLI::App& experiment) {
  CLI::App* app = experiment.add_subcommand(
      "run", "Run a suite: render its scenes, then run every job that is not done");
  const auto flags = std::make_shared<SuiteRunFlags>();
  flags->suite.AddTo(*app);
  const auto add = [app](const char* flag, auto& value, const char* kind, const char* meaning) {
    return app->add_option(flag, value, meaning)->type_name(kind);
  };
  flags->engine.AddTo(*app);
  add("--time-limit", flags->limit_s, "S", "wall time limit of one job; 0: no limit")
      ->check(CLI::Range(0.0, 1e9).description(""))
      ->check(FiniteProblem)
      ->capture_default_str();
  add("--memory-limit", flags->limit_memory_mb, "MB", "address space limit of one job; 0: no limit")
      ->check(CLI::Range(0.0, 1e9).description(""))
      ->check(FiniteProblem)
      ->capture_default_str();
  AddQuiet(*app, flags->quiet);
  app->footer(
      "A job is one estimator with one set of options on one sequence with one seed, and runs "
      "in\nits own process. A failed job leaves its message and log and does not stop the "
      "others.\nRunning the same command again runs failed and missing jobs, also after an "
      "interrupt or a\ncrash.\nOutput files: plan.json, jobs/<id>/ (as clustervo run), "
      "failed/<id>.json, logs/<id>.log.\n"
      "paper is a collection of suites: each runs in DIR/<suite>, and DIR/index.html shows the "
      "results\nas the paper's tables and figures.\nExit code 0: all jobs succeeded, 1: some "
      "failed or the suite is invalid, 2: wrong usage, 130:\ninterrupted.\n"
      "Example: clustervo experiment run ablation -o results/ablation");
  return {app, [flags] {
            const std::optional<Collection> collection = FindCollection(flags->suite.suite);
            return collection ? RunCollection(*collection, *flags) : RunSuite(*flags);
          }};
}

}  // namespace cvo
