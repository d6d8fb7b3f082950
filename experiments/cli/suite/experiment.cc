// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/cli/command.h"

namespace cvo {

Command AddExperimentCommand(CLI::App& program) {
  CLI::App* app = program.add_subcommand(
      "experiment",
      "Run suites of sequences, estimators, options and seeds, and tabulate their results");
  app->footer("Start with: clustervo experiment list, then clustervo experiment run ci -o DIR.");
  return Group(*app, {AddExperimentListCommand(*app), AddExperimentPlanCommand(*app),
                      AddExperimentRunCommand(*app), AddExperimentStatusCommand(*app),
                      AddExperimentTableCommand(*app), AddExperimentTimesCommand(*app),
                      AddExperimentCompareCommand(*app), AddExperimentJobCommand(*app)});
}

}  // namespace cvo
