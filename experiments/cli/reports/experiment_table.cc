// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <memory>

#include "core/files/text_file.h"
#include "experiments/cli/command.h"
#include "experiments/cli/reports/suite_table.h"
#include "reports/tables/table_json.h"

namespace cvo {
namespace {

struct TableFlags {
  std::string folder;
  std::string from;
  std::string reference;
  TableFormat format;
};

int OutputOldTable(const TableFlags& flags) {
  OutputTable(reports::ReadTable(ReadFileBytes(flags.from), flags.from), flags.format,
              {flags.from});
  return 0;
}

}  // namespace

Command AddExperimentTableCommand(CLI::App& experiment) {
  CLI::App* app = experiment.add_subcommand(
      "table", "Print and write the table of a suite's results so far, with confidence intervals");
  const auto flags = std::make_shared<TableFlags>();
  CLI::Option* folder =
      app->add_option("DIR", flags->folder, "output folder of the suite")->type_name("");
  app->add_option("--from", flags->from, "table.json to read instead of DIR, without the results")
      ->type_name("FILE")
      ->excludes(folder);
  app->add_option("--reference", flags->reference,
                  "row that the others are compared with, a variant or key=value; default: the "
                  "suite's; with it, DIR is not written to")
      ->type_name("ROW")
      ->needs(folder);
  AddTableFormat(*app, flags->format);
  app->footer(
      "Every row states how many of its runs it is based on. With format terminal, "
      "DIR/table.json\nand DIR/table.md are written too; csv has all digits; latex and html are "
      "complete documents.\nExit code 1 if jobs failed or have not run yet; absent sequences are "
      "listed.\n"
      "Example: clustervo experiment table results/ablation --format latex -o ablation.tex");
  app->callback([flags] {
    CheckTableFormat(flags->format);
    if (flags->folder.empty() && flags->from.empty()) throw CLI::RequiredError("DIR or --from");
  });
  return {app, [flags] {
            return flags->from.empty()
                       ? OutputSuiteTable(flags->folder, flags->format, flags->reference)
                       : OutputOldTable(*flags);
          }};
}

}  // namespace cvo
