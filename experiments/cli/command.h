// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <string>

namespace cvo {

// A subcommand: its flags are parsed into what `run` holds, and `run` returns the exit code.
struct Command {
  CLI::App* app = nullptr;
  std::function<int()> run;
};

Command AddRunCommand(CLI::App& program);
Command AddDetectCommand(CLI::App& program);
Command AddEvalCommand(CLI::App& program);
Command AddSynthCommand(CLI::App& program);
Command AddExperimentCommand(CLI::App& program);
Command AddCheckCommand(CLI::App& program);
Command AddReportCommand(CLI::App& program);
Command AddOverlayCommand(CLI::App& program);
Command AddFiguresCommand(CLI::App& program);
Command AddPlotCommand(CLI::App& program);
Command AddCompareCommand(CLI::App& program);
Command AddExplainCommand(CLI::App& program);
Command AddManualCommand(CLI::App& program);
Command AddImportCommand(CLI::App& program);
Command AddInfoCommand(CLI::App& program);
Command AddVariantsCommand(CLI::App& program);
Command AddOptionsCommand(CLI::App& program);

// A check for numbers, which the parser lets be NaN and infinite: what is wrong, or empty.
std::string FiniteProblem(const std::string& text);

// What `clustervo --version` prints.
std::string VersionText();

}  // namespace cvo
