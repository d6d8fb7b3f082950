// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// clustervo experiment: run suites, or show what would run.
#include <iostream>
#include <memory>
#include <optional>
#include <set>

#include "core/base/error.h"
#include "experiments/cli/command.h"
#include "experiments/cli/suite/run_suite.h"
#include "experiments/suite/run_plan.h"
#include "synth/write/render_cache.h"

namespace cvo {
namespace {

namespace fs = std::filesystem;

// Prints what is done in the output folder, and what would run.
void PrintPlan(const SuiteRunFlags& flags) {
  const Suite suite = flags.suite.Load();
  const BuiltPlan built = PlanSuite(suite, flags.suite, flags.quiet);
  const SuiteFolder folder{flags.suite.output};
  const std::vector<JobStatus> status = StatusOfAll(folder, built.plan);
  std::cout << suite.name << " (" << SplitOf(suite) << " split): ";
  PrintJobs(folder, built.plan, status, std::cout);
  int frames = 0;
  for (const Preparation& scene : built.preparations) frames += scene.frames;
  if (frames > 0) {
    std::cout << "scenes to render: " << built.preparations.size() << " (" << frames
              << " frames)\n";
  }
}

// Prints the plan section by section. A suite of several sections is planned only once.
void PrintCollection(const Collection& collection, const SuiteRunFlags& flags) {
  std::set<std::string> planned;
  for (const CollectionSection& section : collection.sections) {
    if (section.suite.empty()) continue;
    std::cout << section.title << '\n';
    if (planned.insert(section.suite).second) {
      SuiteRunFlags of_suite = flags;
      of_suite.suite.suite = section.suite;
      of_suite.suite.output =
          (fs::path(flags.suite.output) / SuiteFolderName(section.suite)).string();
      PrintPlan(of_suite);
    }
    if (!section.data.empty()) std::cout << "data: " << section.data << '\n';
    std::cout << '\n';
  }
}

int RunExperiment(const SuiteRunFlags& flags, bool dry_run) {
  const std::optional<Collection> collection = FindCollection(flags.suite.suite);
  if (!dry_run) return collection ? RunCollection(*collection, flags) : RunSuite(flags);
  collection ? PrintCollection(*collection, flags) : PrintPlan(flags);
  return 0;
}

Command AddExperimentRunCommand(CLI::App& experiment) {
  CLI::App* app = experiment.add_subcommand(
      "run", "Run a suite: render its scenes, then run every job that is not done");
  const auto flags = std::make_shared<SuiteRunFlags>();
  flags->suite.AddTo(*app);
  const FlagAdder add{*app};
  flags->engine.AddTo(*app);
  add("--time-limit", flags->limit_s, "S", "wall time limit of one job; 0: no limit")
      ->check(Within(0.0, 1e9))
      ->capture_default_str();
  add("--memory-limit", flags->limit_memory_mb, "MB", "address space limit of one job; 0: no limit")
      ->check(Within(0.0, 1e9))
      ->capture_default_str();
  const auto dry_run = std::make_shared<bool>(false);
  app->add_flag("--dry-run", *dry_run,
                "only print what is done and what would run; nothing is written");
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
      "Examples:\n"
      "  clustervo experiment run ablation -o results/ablation\n"
      "  clustervo experiment run --scenes room@1000:1012 --variants full,paper "
      "--grid pairwise.alpha=0,5,20 \\\n      -o results/alpha   # keeps the suite as suite.json "
      "there");
  return {app, [flags, dry_run] { return RunExperiment(*flags, *dry_run); }};
}

int RunOne(const SuiteFolder& folder, const std::string& id) {
  RunPlannedJob(ParsePlan(ReadJson(folder.plan()), folder.plan().string()), id, folder,
                synth::CacheFolder(), PrintNotice);
  return 0;
}

Command AddExperimentJobCommand(CLI::App& experiment) {
  CLI::App* app = experiment.add_subcommand(
      "job", "Run one job of a suite folder; experiment run starts this for each job");
  const FlagAdder add{*app};
  app->group("");  // hidden from help
  const auto folder = std::make_shared<std::string>();
  const auto id = std::make_shared<std::string>();
  add("DIR", *folder, "", "the suite's folder")->required();
  add("ID", *id, "", "id of the job in DIR/plan.json")->required();
  return {app, [folder, id] { return RunOne({*folder}, *id); }};
}

}  // namespace

Command AddExperimentCommand(CLI::App& program) {
  CLI::App* app = program.add_subcommand(
      "experiment",
      "Run suites of sequences, estimators, options and seeds, and tabulate their results");
  app->footer("Start with: clustervo list suites, then clustervo experiment run ci -o DIR.");
  return Group(*app, {AddExperimentRunCommand(*app), AddExperimentTableCommand(*app),
                      AddExperimentCompareCommand(*app), AddExperimentJobCommand(*app)});
}

}  // namespace cvo
