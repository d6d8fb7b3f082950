// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <vector>

#include "experiments/cli/synth/synth_command.h"

namespace cvo {

Command AddSynthCommand(CLI::App& program) {
  CLI::App* app = program.add_subcommand("synth",
                                         "List, generate, render, preview and check synthetic "
                                         "stereo sequences with exact ground truth");
  app->require_subcommand(1);
  const std::vector<Command> commands = {
      AddSynthListCommand(*app),    AddSynthGenerateCommand(*app), AddSynthRenderCommand(*app),
      AddSynthPreviewCommand(*app), AddSynthCheckCommand(*app),    AddSynthDiversityCommand(*app)};
  app->footer(
      "Start with: clustervo synth render indoor_1 -o indoor_1, then clustervo synth check "
      "indoor_1\n"
      "and clustervo run indoor_1 -o results/indoor_1.");
  return {app, [commands] {
            for (const Command& command : commands) {
              if (command.app->parsed()) return command.run();
            }
            return 0;
          }};
}

}  // namespace cvo
