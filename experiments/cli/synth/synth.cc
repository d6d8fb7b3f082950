// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/cli/command.h"

namespace cvo {

Command AddSynthCommand(CLI::App& program) {
  CLI::App* app = program.add_subcommand("synth",
                                         "List, generate, render, preview, check and summarise "
                                         "synthetic stereo sequences with exact ground truth");
  app->footer(
      "Start with: clustervo synth render indoor_1 -o indoor_1, then clustervo synth check "
      "indoor_1\n"
      "and clustervo run indoor_1 -o results/indoor_1.");
  return Group(*app, {AddSynthListCommand(*app), AddSynthGenerateCommand(*app),
                      AddSynthRenderCommand(*app), AddSynthPreviewCommand(*app),
                      AddSynthCheckCommand(*app), AddSynthDiversityCommand(*app)});
}

}  // namespace cvo
