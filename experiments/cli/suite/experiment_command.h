// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "experiments/cli/command.h"

namespace cvo {

// What `clustervo experiment` offers, one command each.
Command AddExperimentListCommand(CLI::App& experiment);
Command AddExperimentPlanCommand(CLI::App& experiment);
Command AddExperimentTableCommand(CLI::App& experiment);
Command AddExperimentCompareCommand(CLI::App& experiment);
Command AddExperimentRunCommand(CLI::App& experiment);
Command AddExperimentStatusCommand(CLI::App& experiment);
Command AddExperimentJobCommand(CLI::App& experiment);

}  // namespace cvo
