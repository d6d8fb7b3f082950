// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <memory>

#include "experiments/cli/command.h"
#include "experiments/cli/reports/table_format.h"
#include "reports/tables/comparisons.h"
#include "reports/tables/make_table.h"

namespace cvo {
namespace {

namespace fs = std::filesystem;

struct CompareFlags {
  std::string before;
  std::string after;
  TableFormat format;
};

int Compare(const CompareFlags& flags) {
  const reports::Table table = reports::CompareFolders(flags.before, flags.after);
  OutputTable(table, flags.format,
              {fs::path(flags.before) / "plan.json", fs::path(flags.after) / "plan.json"},
              "\n" + reports::MovedText(table));
  return 0;
}

}  // namespace

Command AddExperimentCompareCommand(CLI::App& experiment) {
  CLI::App* app = experiment.add_subcommand("compare",
                                            "Compare the results of two suite folders over their "
                                            "common runs: how they were made and what changed");
  const auto flags = std::make_shared<CompareFlags>();
  app->add_option("A", flags->before, "suite folder with the earlier results")
      ->type_name("")
      ->required();
  app->add_option("B", flags->after, "suite folder with the later results")
      ->type_name("")
      ->required();
  AddTableFormat(*app, flags->format);
  app->footer(
      "The output starts with the options, builds and variants in which they differ. Rows, scenes, "
      "seeds\nand bodies are paired; differences are B - A. Results that define the same metric "
      "differently are\nrejected. For the values of single runs: clustervo compare A/jobs/ID "
      "B/jobs/ID.\n"
      "Example: clustervo experiment compare results/before results/after");
  app->callback([flags] { CheckTableFormat(flags->format); });
  return {app, [flags] { return Compare(*flags); }};
}

}  // namespace cvo
