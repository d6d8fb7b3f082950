// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <string>
#include <vector>

namespace cvo {

// A subcommand. Its flags are parsed into variables that `run` captures; `run` returns the exit
// code.
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
Command AddPlotCommand(CLI::App& program);
Command AddExplainCommand(CLI::App& program);
Command AddManualCommand(CLI::App& program);
Command AddImportCommand(CLI::App& program);
Command AddInfoCommand(CLI::App& program);
Command AddListCommand(CLI::App& program);

// Exit codes for missing or failed results, and for wrong usage.
inline constexpr int kIncomplete = 1;
inline constexpr int kUsage = 2;

// A command with subcommands, of which the parsed one is run.
Command Group(CLI::App& app, std::vector<Command> commands);

// Checks a flag's number, which the parser allows to be NaN or infinite. Returns what is wrong, or
// an empty string.
std::string FiniteProblem(const std::string& text);

// Checks that a flag's value is one of these names, which the flag's help lists. The message for an
// unknown name suggests the nearest one.
CLI::Validator OneOf(std::vector<std::string> names);

// Throws UsageError "--flag: why" if one of these flags was given.
void RefuseFlags(const CLI::App& app, const std::vector<std::string>& flags,
                 const std::string& why);

// What `clustervo --version` prints.
std::string VersionText();

// A subcommand of `clustervo eval`, of its own file.
Command AddEvalBoxesCommand(CLI::App& eval);

// The subcommands of `clustervo synth`.
Command AddSynthRenderCommand(CLI::App& synth);
Command AddSynthPreviewCommand(CLI::App& synth);

// The subcommands of `clustervo experiment`.
Command AddExperimentTableCommand(CLI::App& experiment);
Command AddExperimentCompareCommand(CLI::App& experiment);
Command AddExperimentStatusCommand(CLI::App& experiment);

}  // namespace cvo
