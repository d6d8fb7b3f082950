// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <iostream>
#include <memory>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "experiments/cli/command.h"
#include "experiments/cli/output.h"
#include "reports/gate/check_runs.h"

namespace cvo {
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
  const auto add = [app](const char* flag, auto& value, const char* kind, const char* meaning) {
    return app->add_option(flag, value, meaning)->type_name(kind);
  };
  add("DIR", flags->folder, "", "output folder of the suite")->required();
  CLI::Option* check = add("--baseline", flags->baseline, "FILE", "baseline to check against");
  CLI::Option* write = add("--write-baseline", flags->write_baseline, "FILE",
                           "write these results as the baseline instead of checking");
  add("--gate-seeds", flags->gate_seeds, "N",
      "number of seeds required of checked runs; further seeds of DIR only measure the spread "
      "between seeds; default: all")
      ->check(CLI::Range(1, 10000).description(""))
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
