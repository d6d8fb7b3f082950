// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <memory>

#include "experiments/cli/reports/table_format.h"
#include "experiments/cli/suite/experiment_command.h"
#include "reports/tables/make_table.h"
#include "reports/tables/moved.h"

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
  CLI::App* app = experiment.add_subcommand(
      "compare", "Compare the results of two folders run by run, and say what moved");
  const auto flags = std::make_shared<CompareFlags>();
  app->add_option("A", flags->before, "folder of a suite, as it was")->type_name("")->required();
  app->add_option("B", flags->after, "folder of a suite, as it is")->type_name("")->required();
  AddTableFormat(*app, flags->format);
  app->footer(
      "Rows, scenes, seeds and bodies are paired; differences are B - A. Results that mean "
      "different\n"
      "things by the same metric are refused.\n"
      "Example: clustervo experiment compare results/before results/after");
  app->callback([flags] { CheckTableFormat(flags->format); });
  return {app, [flags] { return Compare(*flags); }};
}

}  // namespace cvo
