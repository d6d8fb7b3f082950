// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <memory>

#include "experiments/cli/reports/suite_table.h"
#include "experiments/cli/suite/experiment_command.h"
#include "reports/tables/read_table.h"

namespace cvo {
namespace {

struct TableFlags {
  std::string folder;
  std::string from;
  TableFormat format;
};

int OutputOldTable(const TableFlags& flags) {
  OutputTable(reports::ReadTableFile(flags.from), flags.format, {flags.from});
  return 0;
}

}  // namespace

Command AddExperimentTableCommand(CLI::App& experiment) {
  CLI::App* app = experiment.add_subcommand(
      "table", "Print and write the table of what a suite has run so far, with its intervals");
  const auto flags = std::make_shared<TableFlags>();
  CLI::Option* folder =
      app->add_option("DIR", flags->folder, "folder that the suite is run to")->type_name("");
  app->add_option("--from", flags->from, "in place of DIR: a table.json, without its results")
      ->type_name("FILE")
      ->excludes(folder);
  AddTableFormat(*app, flags->format);
  app->footer(
      "Every row says on how many of its runs it stands. In a terminal DIR/table.json and\n"
      "DIR/table.md are written too; csv has all digits; latex and html are whole documents.\n"
      "Exit code 1 where jobs failed or have not run yet; sequences that are not there are "
      "listed.\n"
      "Example: clustervo experiment table results/ablation --format latex -o ablation.tex");
  app->callback([flags] {
    CheckTableFormat(flags->format);
    if (flags->folder.empty() && flags->from.empty()) throw CLI::RequiredError("DIR or --from");
  });
  return {app, [flags] {
            return flags->from.empty() ? OutputSuiteTable(flags->folder, flags->format)
                                       : OutputOldTable(*flags);
          }};
}

}  // namespace cvo
