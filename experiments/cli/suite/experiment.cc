// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <vector>

#include "experiments/cli/suite/experiment_command.h"

namespace cvo {

Command AddExperimentCommand(CLI::App& program) {
  CLI::App* app = program.add_subcommand(
      "experiment",
      "Run suites of sequences, estimators, options and seeds, and tabulate their results");
  app->require_subcommand(1);
  const std::vector<Command> commands = {
      AddExperimentListCommand(*app),  AddExperimentPlanCommand(*app),
      AddExperimentRunCommand(*app),   AddExperimentStatusCommand(*app),
      AddExperimentTableCommand(*app), AddExperimentCompareCommand(*app),
      AddExperimentJobCommand(*app)};
  app->footer("Start with: clustervo experiment list, then clustervo experiment run ci -o DIR.");
  return {app, [commands] {
            for (const Command& command : commands) {
              if (command.app->parsed()) return command.run();
            }
            return 0;
          }};
}

}  // namespace cvo
