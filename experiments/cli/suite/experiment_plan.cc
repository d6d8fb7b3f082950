// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
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
#include "experiments/cli/command.h"
#include "experiments/cli/output_file.h"
#include "experiments/cli/progress.h"
#include "experiments/cli/run/run_flags.h"
#include "experiments/cli/run/text_table.h"
#include "experiments/cli/suite/suite_flags.h"
#include "experiments/jobs/job_status.h"
#include "experiments/jobs/suite_folder.h"
#include "experiments/suite/collection.h"
#include "experiments/suite/plan/plan_outlook.h"

namespace cvo {
namespace {

namespace fs = std::filesystem;

// A plan, and how much of it is already done in the output folder.
struct PlanState {
  BuiltPlan built;
  std::vector<PredictedState> outlook;
  std::map<std::string, double> frame_times_s;  // see MeasuredFrameTimes
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

// An earlier plan.json that cannot be read counts as none.
PlanState FindPlanState(const Suite& suite, const PlanRequest& request, const SuiteFolder& folder) {
  PlanState state;
  state.built = BuildPlan(suite, request);
  const EarlierRuns earlier = {
      EarlierPlan(folder), [&](const PlannedJob& job) { return HasFiles(folder, job); },
      [&](const std::string& job) { return FailureOf(folder.failure(job)); }};
  state.outlook = PredictStates(state.built.plan, earlier);
  state.frame_times_s = MeasuredFrameTimes(state.built.plan, earlier,
                                           [&](const std::string& job) { return folder.job(job); });
  return state;
}

struct Flags {
  SuiteFlags suite;
  int jobs = 1;
  bool quiet = false;
};

std::string Duration(double seconds) {
  if (seconds < 90.0) return StrCat(std::ceil(seconds), " s");
  if (seconds < 5400.0) return StrCat(std::round(seconds / 60.0), " min");
  return StrCat(std::round(seconds / 360.0) / 10.0, " h");
}

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
  return EstimatedSeconds(state.built, state.outlook, state.frame_times_s);
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
  out << "estimated time: " << Duration(seconds / processes) << " with "
      << Counted(static_cast<std::size_t>(processes), "process", "processes")
      << (state.frame_times_s.empty() ? " (assuming 35 frames/s, rendering 4 frames/s)\n"
                                      : " (as measured in finished jobs)\n");
}

Suite LoadSuiteOf(const Flags& flags) {
  try {
    return flags.suite.Load();
  } catch (const Error& error) {
    throw UsageError(error.what());
  }
}

PlanState PlanOf(const Flags& flags) {
  const Suite suite = LoadSuiteOf(flags);
  PlanRequest request = flags.suite.Request();
  // Progress is only of interest if images have to be read, and is only shown on a terminal.
  const bool quiet = flags.quiet || ::isatty(STDERR_FILENO) == 0;
  std::optional<Progress> progress;
  request.progress = [&progress, quiet](std::size_t done, std::size_t total) {
    if (!progress) progress.emplace(total, quiet, Progress::Clock::now(), kPlanned);
    progress->Report(done);
  };
  request.notice = [](const std::string& line) { std::cerr << "clustervo: " << line << '\n'; };
  PlanState state = FindPlanState(suite, request, {flags.suite.output});
  progress.reset();
  return state;
}

// Prints the plan section by section. A suite that belongs to several sections is planned only
// once.
void PrintCollection(const Collection& collection, const Flags& flags) {
  std::map<std::string, bool> planned;  // whether input of the suite is missing
  double seconds = 0.0;
  for (const CollectionSection& section : collection.sections) {
    std::cout << section.title << '\n';
    if (section.suite.empty()) {
      std::cout << "no runs of its own\n\n";
      continue;
    }
    if (!planned.contains(section.suite)) {
      Flags of_suite = flags;
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
  std::cout << "estimated time of all suites: " << Duration(seconds / flags.jobs) << '\n';
}

int PrintPlan(const Flags& flags) {
  if (const std::optional<Collection> collection = FindCollection(flags.suite.suite)) {
    PrintCollection(*collection, flags);
  } else {
    Print(PlanOf(flags), flags.jobs, std::cout);
  }
  return 0;
}

}  // namespace

Command AddExperimentPlanCommand(CLI::App& experiment) {
  CLI::App* app = experiment.add_subcommand("plan",
                                            "Show which jobs a suite would run, which are done, "
                                            "why jobs are rerun, and the estimated time");
  const auto flags = std::make_shared<Flags>();
  flags->suite.AddTo(*app);
  app->add_option("-j,--jobs", flags->jobs, "number of processes to estimate the time for")
      ->type_name("N")
      ->check(CLI::Range(1, 10000).description(""))
      ->capture_default_str();
  AddQuiet(*app, flags->quiet);
  app->footer(
      "Nothing is rendered or run. Images whose hashes are not known yet are read, and "
      "their\nhashes are stored in CLUSTERVO_CACHE.\n"
      "Example: clustervo experiment plan ablation -o results/ablation -j 2");
  return {app, [flags] { return PrintPlan(*flags); }};
}

}  // namespace cvo
