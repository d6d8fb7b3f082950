// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// clustervo experiment compare: suites or runs with each other; clustervo check: a suite with a
// baseline.
#include <iostream>
#include <memory>
#include <set>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "core/files/json/json_record.h"
#include "core/files/text/number.h"
#include "core/record/metric_catalogue.h"
#include "experiments/cli/command.h"
#include "experiments/cli/reports/reports.h"
#include "reports/gate/check_runs.h"
#include "reports/runs/run_comparison.h"
#include "reports/tables/make_table.h"
#include "reports/tables/table_texts.h"

namespace cvo {
namespace {

namespace fs = std::filesystem;
using reports::PairedComparison;
using reports::RunComparison;

struct CompareFlags {
  std::vector<std::string> folders;
  bool all = false;
  bool json = false;
  TableFormat format;
};

std::string Signed(double value) { return FormatSigned(value, 3); }

void PrintRuns(const RunComparison& comparison) {
  std::cout << "sequence " << comparison.sequence << '\n';
  TextTable table({"run", "seed", "frames", "status", "folder"});
  std::set<std::string> builds;
  for (const reports::ComparedRun& run : comparison.runs) {
    table.Add({run.name, StrCat(run.seed),
               StrCat(run.first_frame, ":", run.first_frame + run.frames), run.status, run.folder});
    builds.insert(run.build);
  }
  table.Print(std::cout);
  if (builds.size() > 1) std::cout << "the runs are of different builds of the program\n";
}

// Prints at most kMost options; --json contains all of them.
void PrintOptions(const RunComparison& comparison) {
  constexpr std::size_t kMost = 12;
  std::set<std::string> paths;
  for (const reports::ComparedRun& run : comparison.runs) {
    for (const auto& [path, value] : run.options) paths.insert(path);
  }
  if (paths.empty()) return;
  std::vector<std::string> header = {"option"};
  for (const reports::ComparedRun& run : comparison.runs) header.push_back(run.name);
  TextTable table(header);
  std::size_t shown = 0;
  for (const std::string& path : paths) {
    if (shown++ == kMost) break;
    std::vector<std::string> row = {path};
    for (const reports::ComparedRun& run : comparison.runs) {
      const auto found = run.options.find(path);
      row.push_back(found == run.options.end() ? "-" : found->second);
    }
    table.Add(row);
  }
  std::cout << '\n';
  table.Print(std::cout);
  if (paths.size() > kMost) {
    std::cout << "and " << paths.size() - kMost << " more options that differ\n";
  }
}

void PrintMetricsOf(const RunComparison& comparison, bool all) {
  std::vector<std::string> header = {"metric", "unit"};
  for (const reports::ComparedRun& run : comparison.runs) header.push_back(run.name);
  header.emplace_back(comparison.runs.size() == 2 ? "difference" : "note");
  TextTable table(header);
  for (const reports::ComparedMetric& metric : comparison.metrics) {
    const auto form = reports::FindForm(metric.name);
    const bool main_form = form && !form->causal && form->bodies == reports::BodyGroup::kMovers;
    if (!all && !main_form) continue;
    std::vector<std::string> row = {metric.name, metric.unit};
    for (const auto& value : metric.values) row.push_back(value ? ReadableNumber(*value) : "-");
    row.emplace_back();
    if (!metric.differing.empty()) {
      row.back() = "defined differently: " + metric.differing;
    } else if (metric.values.size() == 2 && metric.values[0] && metric.values[1]) {
      row.back() = Signed(*metric.values[1] - *metric.values[0]);
    }
    table.Add(row);
  }
  std::cout << '\n';
  table.Print(std::cout);
}

void PrintPaired(const std::vector<PairedComparison>& list, const std::string& heading,
                 const std::string& first, const std::string& value_heading, bool several) {
  if (list.empty()) return;
  std::cout << '\n' << heading << '\n';
  std::vector<std::string> header = {
      "what",          list.front().frames > 0 ? "blocks of frames" : "pairs",
      "unit",          first,
      value_heading,   "difference",
      "95 % interval", "in %",
      "verdict"};
  if (several) header.insert(header.begin(), "run");
  TextTable table(header);
  for (const PairedComparison& paired : list) {
    const reports::Difference& difference = paired.difference;
    const std::string pairs =
        paired.frames > 0 ? StrCat(difference.pairs, " (", Counted(paired.frames, "frame"), ")")
                          : StrCat(difference.pairs);
    const auto& interval = difference.interval;
    std::vector<std::string> row = {
        paired.what,
        pairs,
        paired.unit,
        ReadableNumber(difference.reference_value),
        ReadableNumber(difference.value),
        Signed(difference.difference),
        interval ? StrCat(Signed(interval->low), " to ", Signed(interval->high)) : "-",
        difference.percent ? Signed(*difference.percent) : "-",
        paired.verdict};
    if (several) row.insert(row.begin(), paired.run);
    table.Add(row);
  }
  table.Print(std::cout);
}

void PrintComparison(const RunComparison& comparison, bool all) {
  PrintRuns(comparison);
  PrintOptions(comparison);
  PrintMetricsOf(comparison, all);
  const bool several = comparison.runs.size() > 2;
  const std::string value = several ? "run" : comparison.runs.back().name;
  const std::string& first = comparison.runs.front().name;
  PrintPaired(comparison.by_frame,
              "mean position error over the frames that both estimate. camera: each run aligned to "
              "the truth by SE(3)\nover these frames alone (camera_ate_mean covers all frames of a "
              "run); bodies: in the world of the object metrics:",
              first, value, several);
  PrintPaired(comparison.by_body, "over the bodies that both runs have:", first, value, several);
  std::cout
      << "\ndifferences: run minus first (" << comparison.runs.front().name
      << "). Intervals are bootstrapped over blocks of\nconsecutive frames, or over bodies, "
         "of this one sequence: they say nothing about other scenes.\nbetter, worse: the interval "
         "excludes 0 and p, corrected for all comparisons here (Holm), is below 0.05.\n";
  for (const std::string& note : comparison.notes) std::cout << "not compared: " << note << '\n';
}

int CompareSomeRuns(const CompareFlags& flags) {
  constexpr std::size_t kMost = 20;
  if (flags.folders.size() > kMost) {
    throw UsageError(
        StrCat("DIR: found ", flags.folders.size(), " runs, expected at most ", kMost));
  }
  const RunComparison comparison =
      reports::CompareRuns({flags.folders.begin(), flags.folders.end()});
  if (flags.json) {
    std::cout << FileText(comparison);
  } else {
    PrintComparison(comparison, flags.all);
  }
  return 0;
}

int CompareTwoSuites(const CompareFlags& flags) {
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
  CheckNoCollection(folder);
  ThrowError(folder.string(), "no result.json or plan.json",
             "the output folder of a run or of a suite");
}

int Compare(const CLI::App& app, const CompareFlags& flags) {
  const std::string& first = flags.folders.front();
  const bool suites = IsSuite(first);
  for (const std::string& folder : flags.folders) {
    if (IsSuite(folder) == suites) continue;
    throw UsageError(StrCat(folder, ": found the folder of a ", suites ? "run" : "suite",
                            ", expected that of a ", suites ? "suite" : "run", ", as ", first));
  }
  if (suites) {
    RefuseFlags(app, {"--all", "--json"}, "applies to runs, found suites");
    return CompareTwoSuites(flags);
  }
  RefuseFlags(app, {"--format", "--output", "--long"}, "applies to suites, found runs");
  return CompareSomeRuns(flags);
}

}  // namespace

Command AddExperimentCompareCommand(CLI::App& experiment) {
  CLI::App* app = experiment.add_subcommand(
      "compare",
      "Compare two suites over their common runs, or runs on one sequence by frame and by body");
  const FlagAdder add{*app};
  const auto flags = std::make_shared<CompareFlags>();
  add("DIR", flags->folders, "",
      "output folders of two suites, the earlier first; or of runs (of clustervo run "
      "or eval, or DIR/jobs/ID of a suite), the first of which is the reference")
      ->required()
      ->expected(-2);
  app->add_flag("--all", flags->all,
                "runs: also print causal metrics and the metrics of static bodies");
  app->add_flag("--json", flags->json, "runs: print JSON, with all metrics, pairs and intervals");
  flags->format.AddTo(*app);
  for (const char* flag : {"--format", "--output", "--long"}) {
    CLI::Option* option = app->get_option(flag);
    option->description("suites: " + option->get_description());
  }
  app->footer(
      "Suites: the output starts with the options, builds and variants in which they differ. Rows, "
      "scenes,\nseeds and bodies are paired; differences are B - A. Results that define the same "
      "metric\ndifferently are rejected.\n"
      "Runs: intervals cover the frames or bodies of this sequence only. To draw conclusions about "
      "other\nscenes, run a suite.\n"
      "Examples:\n"
      "  clustervo experiment compare results/before results/after\n"
      "  clustervo experiment compare results/room_static results/room_full");
  app->callback([flags] { flags->format.Check(); });
  return {app, [app, flags] { return Compare(*app, *flags); }};
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
  bool exact = false;
};

std::vector<std::filesystem::path> ReadBy(const CheckFlags& flags) {
  return {flags.baseline, std::filesystem::path(flags.folder) / "plan.json"};
}

int WriteBaseline(const CheckFlags& flags) {
  CheckOutputFile(flags.write_baseline, ReadBy(flags));
  const reports::Baseline baseline = reports::MakeBaseline(flags.folder, flags.gate_seeds);
  WriteOutputFile(flags.write_baseline, reports::BaselineText(baseline), ReadBy(flags));
  std::cout << baseline.suite << ": " << Counted(baseline.jobs.size(), "run") << " with "
            << Counted(baseline.metrics.size(), "metric") << "; checked runs need "
            << Counted(baseline.seeds.size(), "seed") << "\nwritten: " << flags.write_baseline
            << '\n';
  return 0;
}

int Check(const CheckFlags& flags) {
  for (const std::string& file : {flags.junit, flags.markdown}) {
    if (!file.empty()) CheckOutputFile(file, ReadBy(flags));
  }
  const reports::Baseline baseline = reports::ReadBaseline(flags.baseline);
  const reports::GateReport report = reports::CheckRuns(flags.folder, baseline, flags.exact);
  if (!flags.junit.empty()) WriteOutputFile(flags.junit, reports::GateJunit(report), ReadBy(flags));
  if (!flags.markdown.empty())
    WriteOutputFile(flags.markdown, reports::GateMarkdown(report), ReadBy(flags));
  std::cout << reports::GateText(report);
  std::cout << '\n' << reports::GateVerdict(report) << '\n';
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
  app->add_flag("--exact", flags->exact,
                "also fail the check if any value differs from the baseline, better or worse; not "
                "applied if compiler, libraries or level of the processor are not the baseline's")
      ->needs(check);
  check->excludes(write);
  app->footer(
      "Runs are paired by scene and seed. A variant regresses in a metric if its mean difference "
      "is\nworse than noise between seeds fails one check in a hundred.\nExit code 1 on a "
      "regression, or if a job or a metric of the baseline is missing, failed or is\ndefined "
      "differently. Times are relative to the variant static and only cause warnings.\n"
      "Example: clustervo check results/ci --baseline reports/baselines/ci.json");
  app->callback([flags] {
    if (!flags->baseline.empty() || !flags->write_baseline.empty()) return;
    throw CLI::RequiredError("--baseline or --write-baseline");
  });
  return {app, [flags] { return flags->baseline.empty() ? WriteBaseline(*flags) : Check(*flags); }};
}

}  // namespace cvo
