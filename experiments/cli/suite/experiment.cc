// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// clustervo experiment: run, times, and the job that run starts.
#include <iostream>
#include <memory>

#include "core/base/lists.h"
#include "core/files/json/json.h"
#include "experiments/cli/command.h"
#include "experiments/cli/output_place.h"
#include "experiments/cli/run/run_flags.h"
#include "experiments/cli/suite/run_suite.h"
#include "experiments/suite/run_plan.h"
#include "synth/write/render_cache.h"

namespace cvo {
namespace {

int RunOne(const SuiteFolder& folder, const std::string& id) {
  FileHashHooks hooks;
  hooks.notice = [](const std::string& line) { std::cerr << "clustervo: " << line << '\n'; };
  const JobCache cache(synth::CacheFolder(), CacheLimit(""), hooks);
  RunPlannedJob(ParsePlan(ReadJson(folder.plan()), folder.plan().string()), id, folder, cache);
  return 0;
}

Command AddExperimentJobCommand(CLI::App& experiment) {
  CLI::App* app = experiment.add_subcommand(
      "job", "Run one job of a suite folder; experiment run starts this for each job");
  const auto folder = std::make_shared<std::string>();
  const auto id = std::make_shared<std::string>();
  app->group("");  // hidden from help
  app->add_option("DIR", *folder, "the suite's folder")->type_name("")->required();
  app->add_option("ID", *id, "id of the job in DIR/plan.json")->type_name("")->required();
  return {app, [folder, id] { return RunOne({*folder}, *id); }};
}

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

}  // namespace

Command AddExperimentCommand(CLI::App& program) {
  CLI::App* app = program.add_subcommand(
      "experiment",
      "Run suites of sequences, estimators, options and seeds, and tabulate their results");
  app->footer("Start with: clustervo list suites, then clustervo experiment run ci -o DIR.");
  return Group(*app, {AddExperimentRunCommand(*app), AddExperimentStatusCommand(*app),
                      AddExperimentTableCommand(*app), AddExperimentCompareCommand(*app),
                      AddExperimentJobCommand(*app)});
}

}  // namespace cvo
