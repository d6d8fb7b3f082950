// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "experiments/cli/command.h"

namespace cvo {

// What `clustervo synth` offers, one command each.
Command AddSynthListCommand(CLI::App& synth);
Command AddSynthGenerateCommand(CLI::App& synth);
Command AddSynthDiversityCommand(CLI::App& synth);
Command AddSynthRenderCommand(CLI::App& synth);
Command AddSynthPreviewCommand(CLI::App& synth);
Command AddSynthCheckCommand(CLI::App& synth);

}  // namespace cvo
