// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// clustervo experiment: run suites, show what is done or would be done, and tabulate results.
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "core/files/json/json.h"
#include "experiments/cli/command.h"
#include "experiments/cli/suite/run_suite.h"
#include "experiments/suite/collection.h"
#include "experiments/suite/plan_outlook.h"
#include "experiments/suite/run_plan.h"
#include "synth/write/render_cache.h"

namespace cvo {
namespace {

namespace fs = std::filesystem;

// A plan, and how much of it is already done in the output folder.
struct PlanState {
  BuiltPlan built;
  std::vector<PredictedState> outlook;
  std::optional<double> frame_time_s;  // see MeasuredFrameTime_s
};

std::optional<Plan> EarlierPlan(const SuiteFolder& folder) {
  try {
    if (fs::exists(folder.plan())) return ParsePlan(ReadJson(folder.plan()), folder.plan());
  } catch (const Error&) {
  }
  return std::nullopt;
}

std::string FailureOf(const fs::path& file) {
  try {
    if (fs::exists(file)) return ReadJson(file).at("message");
  } catch (const std::exception&) {
    return "reason not readable in " + file.string();
  }
  return "";
}

struct StatusFlags {
  SuiteFlags suite;
  int jobs = 1;
  bool quiet = false;
};

std::size_t Count(const std::vector<PredictedState>& outlook, JobState state) {
  return static_cast<std::size_t>(
      std::count_if(outlook.begin(), outlook.end(),
                    [state](const PredictedState& job) { return job.state == state; }));
}

// Prints "  12 x <reason>" for each reason, in order of first occurrence.
void PrintReasons(const std::vector<PredictedState>& outlook, JobState state, std::ostream& out) {
  using Reason = std::pair<std::string, int>;
  std::vector<Reason> reasons;
  for (const PredictedState& job : outlook) {
    if (job.state == state) ++FindOrAdd(reasons, &Reason::first, {job.why, 0}).second;
  }
  for (const auto& [why, count] : reasons) out << "  " << count << " x " << why << '\n';
}

void PrintPreparations(const std::vector<Preparation>& preparations, std::ostream& out) {
  std::map<Stage, std::size_t> counts;
  std::map<Stage, int> frames;
  for (const Preparation& preparation : preparations) {
    ++counts[preparation.stage];
    frames[preparation.stage] += preparation.frames;
  }
  const std::size_t scenes = counts[Stage::kDrawing] + counts[Stage::kNoise];
  if (scenes > 0) {
    out << "scenes to render: " << scenes << " (" << frames[Stage::kDrawing] + frames[Stage::kNoise]
        << " frames), " << counts[Stage::kDrawing]
        << " of them from scratch, the rest from cached renders\n";
  }
  if (counts[Stage::kBoxes] > 0) {
    out << "sequences to detect boxes in: " << counts[Stage::kBoxes] << " ("
        << frames[Stage::kBoxes] << " frames)\n";
  }
}

double SecondsOf(const PlanState& state) {
  return EstimatedSeconds(state.built, state.outlook, state.frame_time_s);
}

void Print(const PlanState& state, int processes, std::ostream& out) {
  const Plan& plan = state.built.plan;
  out << "suite " << plan.suite.name << ": " << plan.jobs.size() << " jobs on "
      << plan.suite.sequences.size() << " sequences";
  out << " (" << SplitOf(plan.suite) << " split)\n";
  const std::array<std::pair<JobState, const char*>, 4> states = {
      {{JobState::kDone, "done"},
       {JobState::kRuns, "to run"},
       {JobState::kPrepares, "to run after rendering or detection"},
       {JobState::kMissing, "missing, left out"}}};
  for (const auto& [job_state, label] : states) {
    const std::size_t count = Count(state.outlook, job_state);
    if (count == 0) continue;
    out << label << ": " << count << '\n';
    if (job_state == JobState::kRuns || job_state == JobState::kMissing) {
      PrintReasons(state.outlook, job_state, out);
    }
  }
  PrintPreparations(state.built.preparations, out);
  const double seconds = SecondsOf(state);
  if (seconds == 0.0) {
    out << "nothing to compute\n";
    return;
  }
  out << "estimated time: " << DurationText(seconds / processes) << " with "
      << Counted(static_cast<std::size_t>(processes), "process", "processes")
      << (state.frame_time_s ? " (as measured in finished jobs)\n"
                             : " (assuming 35 frames/s, rendering 4 frames/s)\n");
}

// An earlier plan.json that cannot be read counts as none.
PlanState PlanOf(const StatusFlags& flags) {
  Suite suite;
  try {
    suite = flags.suite.Load();
  } catch (const Error& error) {
    throw UsageError(error.what());
  }
  const SuiteFolder folder{flags.suite.output};
  PlanState state;
  state.built = PlanSuite(suite, flags.suite, flags.quiet);
  const EarlierRuns earlier = {
      EarlierPlan(folder), [&](const PlanJob& job) { return HasFiles(folder, job); },
      [&](const std::string& job) { return FailureOf(folder.failure(job)); }};
  state.outlook = PredictStates(state.built.plan, earlier);
  state.frame_time_s = MeasuredFrameTime_s(state.built.plan, earlier,
                                           [&](const std::string& job) { return folder.job(job); });
  return state;
}

// Prints the plan section by section. A suite that belongs to several sections is planned only
// once.
void PrintCollection(const Collection& collection, const StatusFlags& flags) {
  std::map<std::string, bool> planned;  // whether input of the suite is missing
  double seconds = 0.0;
  for (const CollectionSection& section : collection.sections) {
    std::cout << section.title << '\n';
    if (section.suite.empty()) {
      std::cout << "no runs of its own\n\n";
      continue;
    }
    if (!planned.contains(section.suite)) {
      StatusFlags of_suite = flags;
      of_suite.suite.suite = section.suite;
      of_suite.suite.output =
          (fs::path(flags.suite.output) / SuiteFolderName(section.suite)).string();
      const PlanState state = PlanOf(of_suite);
      Print(state, flags.jobs, std::cout);
      seconds += SecondsOf(state);
      planned[section.suite] = Count(state.outlook, JobState::kMissing) > 0;
    }
    if (planned[section.suite]) std::cout << "get it: " << section.data << '\n';
    std::cout << '\n';
  }
  std::cout << "estimated time of all suites: " << DurationText(seconds / flags.jobs) << '\n';
}

int PrintPlan(const StatusFlags& flags) {
  if (const std::optional<Collection> collection = FindCollection(flags.suite.suite)) {
    PrintCollection(*collection, flags);
  } else {
    Print(PlanOf(flags), flags.jobs, std::cout);
  }
  return 0;
}

Json StatusToJson(const SuiteFolder& folder, const Plan& plan,
                  const std::vector<JobStatus>& status) {
  const PlanOutcome counts = CountJobs(status);
  Json jobs = Json::array();
  for (std::size_t i = 0; i < status.size(); ++i) {
    const PlanJob& job = plan.jobs[i];
    jobs.push_back({{"job", job.job},
                    {"name", Describe(job)},
                    {"state", ToString(status[i].state)},
                    {"message", status[i].message},
                    {"log", job.job.empty() ? "" : folder.log(job.job).string()}});
  }
  return {{"schema_version", 1},
          {"kind", "status"},
          {"suite", plan.suite.name},
          {"counts",
           {{"done", counts.done},
            {"failed", counts.failed},
            {"missing", counts.missing},
            {"no_sequence", counts.no_sequence}}},
          {"jobs", std::move(jobs)}};
}

// What is done in an output folder.
int ShowStatus(const std::string& path, bool json) {
  CheckNoCollection(path);
  const SuiteFolder folder{path};
  if (!std::filesystem::exists(folder.plan())) {
    ThrowError(path, "no plan.json", "an output folder of clustervo experiment run");
  }
  const Plan plan = ParsePlan(ReadJson(folder.plan()), folder.plan().string());
  const std::vector<JobStatus> status = StatusOfAll(folder, plan);
  if (json) {
    std::cout << DumpJson(StatusToJson(folder, plan, status));
  } else {
    std::cout << plan.suite.name << ": ";
    PrintJobs(folder, plan, status, std::cout);
  }
  const PlanOutcome counts = CountJobs(status);
  return counts.failed + counts.missing == 0 ? 0 : kIncomplete;
}

Command AddExperimentStatusCommand(CLI::App& experiment) {
  CLI::App* app = experiment.add_subcommand(
      "status",
      "Show which jobs of a suite folder are done, failed or missing; of a suite, which would run, "
      "why, and for how long");
  const FlagAdder add{*app};
  const auto flags = std::make_shared<StatusFlags>();
  flags->suite.AddTo(*app);
  app->get_option("SUITE")->description(
      "output folder of a suite; or, with -o, a suite (clustervo list suites) or a suite file");
  app->get_option("--output")->required(false);
  add("-j,--jobs", flags->jobs, "N", "number of processes to estimate the time for")
      ->check(Within(1, 10000))
      ->capture_default_str();
  const auto json = std::make_shared<bool>(false);
  app->add_flag("--json", *json, "of a folder: print JSON, one entry per job");
  AddQuiet(*app, flags->quiet);
  app->footer(
      "Nothing is rendered or run; can be used while the suite runs. Exit code of a folder: 0 if "
      "all jobs\nwhose sequence is present are done, 1 if some are not. Images whose hashes are "
      "not "
      "known yet are\nread, and their hashes are stored in CLUSTERVO_CACHE.\n"
      "Examples:\n"
      "  clustervo experiment status results/ablation\n"
      "  clustervo experiment status ablation -o results/ablation -j 2");
  return {app, [flags, json] {
            if (flags->suite.output.empty()) return ShowStatus(flags->suite.suite, *json);
            return PrintPlan(*flags);
          }};
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

int RunOne(const SuiteFolder& folder, const std::string& id) {
  FileHashHooks hooks;
  hooks.notice = PrintNotice;
  const JobCache cache(synth::CacheFolder(), CacheLimit(""), hooks);
  RunPlannedJob(ParsePlan(ReadJson(folder.plan()), folder.plan().string()), id, folder, cache);
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
  return Group(*app, {AddExperimentRunCommand(*app), AddExperimentStatusCommand(*app),
                      AddExperimentTableCommand(*app), AddExperimentCompareCommand(*app),
                      AddExperimentJobCommand(*app)});
}

}  // namespace cvo
