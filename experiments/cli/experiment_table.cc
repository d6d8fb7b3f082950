// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <memory>

#include "experiments/cli/experiment_command.h"
#include "experiments/cli/suite_table.h"

namespace cvo {

Command AddExperimentTableCommand(CLI::App& experiment) {
  CLI::App* app = experiment.add_subcommand(
      "table", "Print and write the table of what a suite has run so far, with its intervals");
  const auto folder = std::make_shared<std::string>();
  app->add_option("DIR", *folder, "folder that the suite is run to")->type_name("")->required();
  app->footer(
      "Written: DIR/table.json and DIR/table.md. Every row says on how many of its runs it "
      "stands.\n"
      "Exit code 1 where jobs failed or have not run yet; sequences that are not there are "
      "listed.\n"
      "Example: clustervo experiment table results/ablation");
  return {app, [folder] { return WriteSuiteTable(*folder); }};
}

}  // namespace cvo
