// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// clustervo experiment compare: suites or runs with each other; clustervo check: a suite with a
// baseline.
#include <algorithm>
#include <array>
#include <iostream>
#include <memory>
#include <optional>
#include <set>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "core/files/text/closest_names.h"
#include "core/record/metric_catalogue.h"
#include "core/record/suite_runs.h"
#include "experiments/cli/command.h"
#include "experiments/cli/reports/reports.h"
#include "reports/gate/check_runs.h"
#include "reports/tables/make_table.h"

namespace cvo {
namespace {

namespace fs = std::filesystem;
struct CompareFlags {
  std::vector<std::string> folders;
  TableFormat format;
};

// Metrics of the table of runs, if any of them has these.
constexpr std::array<const char*, 8> kRunMetrics = {
    "camera_ate",      "camera_trpe_1_frame", "object_ate",       "object_success_10cm",
    "object_coverage", "object_id_switches",  "moving_precision", "moving_recall"};

std::vector<reports::RunSummary> ReadRunsToCompare(const std::vector<std::string>& folders) {
  std::vector<reports::RunSummary> runs;
  for (const std::string& folder : folders) {
    runs.push_back(reports::ReadRun(fs::path(folder) / "result.json", reports::AllMetricNames()));
    const std::string& sequence = runs.back().sequence.name;
    if (sequence != runs.front().sequence.name) {
      ThrowError(folder, "a run of " + sequence, "one of " + runs.front().sequence.name);
    }
  }
  return runs;
}

// The table of a suite of these runs, with the first as the reference. Throws Error for runs on
// different sequences and for a run given twice.
reports::Table TableOfRuns(const std::vector<std::string>& folders) {
  const std::vector<reports::RunSummary> runs = ReadRunsToCompare(folders);
  std::vector<std::string> variants;
  for (const reports::RunSummary& run : runs) variants.push_back(run.variant);
  const std::vector<std::string> names = UniqueNames(variants, folders);
  reports::SuitePlan plan;
  plan.name = "Runs on " + runs.front().sequence.name;
  plan.metrics.assign(kRunMetrics.begin(), kRunMetrics.end());
  plan.reference = names.front();
  std::set<std::string> jobs;
  std::vector<reports::SuiteRun> results;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (!jobs.insert(runs[i].job).second) ThrowError(folders[i], "the same run twice", "each once");
    reports::PlannedRun& planned = plan.runs.emplace_back();
    planned.keys = {{"sequence", runs[i].sequence.name}, {"variant", names[i]}};
    planned.seed = runs[i].seed;
    if (runs[i].system) planned.system = names[i];
    results.push_back({planned, runs[i].status, runs[i].message, "", std::nullopt});
    if (runs[i].status != "failed") results.back().run = runs[i];
  }
  return reports::MakeTable(plan, results, fs::current_path(), {}, DefaultOptions());
}

int CompareSuites(const CompareFlags& flags) {
  if (flags.folders.size() != 2) {
    throw UsageError(StrCat("DIR: found ", flags.folders.size(), " suites, expected 2"));
  }
  const fs::path before = flags.folders[0];
  const fs::path after = flags.folders[1];
  const reports::Table table = reports::CompareFolders(before, after);
  OutputTable(table, flags.format, {before / "plan.json", after / "plan.json"},
              "\n" + reports::MovedText(table));
  return 0;
}

bool IsSuite(const fs::path& folder) {
  if (fs::exists(folder / "plan.json")) return true;
  if (fs::exists(folder / "result.json")) return false;
  ThrowError(folder.string(), "no result.json or plan.json",
             "the output folder of a run or of a suite");
}

int Compare(const CompareFlags& flags) {
  const std::string& first = flags.folders.front();
  const bool suites = IsSuite(first);
  for (const std::string& folder : flags.folders) {
    if (IsSuite(folder) == suites) continue;
    throw UsageError(StrCat(folder, ": found the folder of a ", suites ? "run" : "suite",
                            ", expected that of a ", suites ? "suite" : "run", ", as ", first));
  }
  if (suites) return CompareSuites(flags);
  OutputTable(TableOfRuns(flags.folders), flags.format,
              {flags.folders.begin(), flags.folders.end()});
  return 0;
}

}  // namespace

Command AddExperimentCompareCommand(CLI::App& experiment) {
  CLI::App* app = experiment.add_subcommand(
      "compare", "Compare two suites over their common runs, or runs on one sequence");
  const FlagAdder add{*app};
  const auto flags = std::make_shared<CompareFlags>();
  add("DIR", flags->folders, "",
      "output folders of two suites, the earlier first; or of runs (of clustervo run "
      "or eval, or DIR/jobs/ID of a suite), the first of which is the reference")
      ->required()
      ->expected(-2);
  flags->format.AddTo(*app);
  flags->format.all = true;
  app->footer(
      "Suites: the output starts with the options, builds and variants in which they differ. Rows, "
      "scenes,\nseeds and bodies are paired; differences are B - A. Results that define the same "
      "metric\ndifferently are rejected.\n"
      "Runs: intervals cover the bodies of this sequence only. To draw conclusions about other "
      "scenes,\nrun a suite.\n"
      "Examples:\n"
      "  clustervo experiment compare results/before results/after\n"
      "  clustervo experiment compare results/room_static results/room_full");
  return {app, [flags] { return Compare(*flags); }};
}

namespace {

constexpr int kRegressed = 1;

struct CheckFlags {
  std::string folder;
  std::string baseline;
  std::string write_baseline;
  std::size_t gate_seeds = 0;
  std::string junit;
  std::string markdown;
  bool tolerant = false;
};

std::vector<std::filesystem::path> ReadBy(const CheckFlags& flags) {
  return {flags.baseline, std::filesystem::path(flags.folder) / "plan.json"};
}

int WriteBaseline(const CheckFlags& flags) {
  CheckOutputFile(flags.write_baseline, ReadBy(flags));
  const std::string begins = reports::BaselineText({});
  CheckOwnFile(flags.write_baseline, begins.substr(0, begins.find("\"suite\"")));
  const reports::Baseline baseline = reports::MakeBaseline(flags.folder, flags.gate_seeds);
  WriteOutputFile(flags.write_baseline, reports::BaselineText(baseline), ReadBy(flags));
  std::cout << baseline.suite << ": " << Counted(baseline.jobs.size(), "run") << " with "
            << Counted(baseline.metrics.size(), "metric") << "; checked runs need "
            << Counted(baseline.seeds.size(), "seed") << "\n\n"
            << reports::NoticedText(baseline) << "\nwritten: " << flags.write_baseline << '\n';
  return 0;
}

int Check(const CheckFlags& flags) {
  for (const std::string& file : {flags.junit, flags.markdown}) {
    if (!file.empty()) CheckOutputFile(file, ReadBy(flags));
  }
  const reports::Baseline baseline = reports::ReadBaseline(flags.baseline);
  const reports::GateReport report = reports::CheckRuns(flags.folder, baseline, !flags.tolerant);
  if (!flags.junit.empty()) WriteOutputFile(flags.junit, reports::GateJunit(report), ReadBy(flags));
  if (!flags.markdown.empty())
    WriteOutputFile(flags.markdown, reports::GateMarkdown(report), ReadBy(flags));
  std::cout << reports::GateText(report) << '\n' << reports::GateVerdict(report) << '\n';
  return report.Failed() ? kRegressed : 0;
}

}  // namespace

Command AddCheckCommand(CLI::App& program) {
  CLI::App* app = program.add_subcommand(
      "check", "Check the results of a suite against a baseline (regression gate)");
  const auto flags = std::make_shared<CheckFlags>();
  const FlagAdder add{*app};
  add("DIR", flags->folder, "", "output folder of the suite")->required();
  CLI::Option* check = add("--baseline", flags->baseline, "FILE", "baseline to check against");
  CLI::Option* write = add("--write-baseline", flags->write_baseline, "FILE",
                           "write these results as the baseline instead of checking");
  add("--gate-seeds", flags->gate_seeds, "N",
      "number of seeds required of checked runs; further seeds of DIR only measure the spread "
      "between seeds; default: all")
      ->check(Within(1, 10000))
      ->needs(write);
  add("--junit", flags->junit, "FILE", "also write JUnit XML")->needs(check);
  add("--markdown", flags->markdown, "FILE", "also write a summary in Markdown")->needs(check);
  app->add_flag(
         "--tolerant", flags->tolerant,
         "hold runs on the baseline's platform (compiler, libraries, level of the processor) "
         "to tolerances too, instead of to equal values")
      ->needs(check);
  check->excludes(write);
  app->footer(
      "Runs are paired by scene and seed. Those on the baseline's platform must have its values. A "
      "variant\nregresses in a metric if it is worse by more than noise between seeds explains in "
      "one check of a\nhundred.\nExit code 1 on a regression or change, or if a job or a metric of "
      "the baseline is missing, failed or\nis defined differently.\n"
      "Example: clustervo check results/ci --baseline reports/baselines/ci.json");
  app->callback([flags] {
    if (!flags->baseline.empty() || !flags->write_baseline.empty()) return;
    throw CLI::RequiredError("--baseline or --write-baseline");
  });
  return {app, [flags] { return flags->baseline.empty() ? WriteBaseline(*flags) : Check(*flags); }};
}

}  // namespace cvo
