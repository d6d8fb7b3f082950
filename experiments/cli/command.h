// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "core/base/error.h"

namespace cvo {

// A request that is impossible whatever the files contain: exit code 2, as for wrong flags.
class UsageError : public Error {
 public:
  using Error::Error;
};

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

// The subcommands of `clustervo experiment`.
Command AddExperimentTableCommand(CLI::App& experiment);
Command AddExperimentCompareCommand(CLI::App& experiment);

// Throws UsageError if a folder was given to a flag that takes a file.
void CheckNoFolder(const char* flag, const std::string& file);

// Add -q, and --threads with the number of CPUs as its default. Every long command has them.
void AddQuiet(CLI::App& app, bool& quiet);
void AddThreads(CLI::App& app, int& threads);
// The number of CPUs.
int DefaultThreads();

// Parses the value of --seed exactly: the flag parser itself would wrap, saturate or read octal.
std::uint64_t ParseSeed(const std::string& text);

// Returns load(). If `name` is not a file, an Error thrown by load() is wrong usage: UsageError.
template <typename Load>
auto LoadNamed(const std::string& name, const Load& load) {
  try {
    return load();
  } catch (const Error& error) {
    std::error_code none;
    if (std::filesystem::exists(name, none)) throw;
    throw UsageError(error.what());
  }
}

}  // namespace cvo
