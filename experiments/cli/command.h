// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/files/atomic_file.h"
#include "experiments/datasets/sequence.h"

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
Command AddCrfCommand(CLI::App& program);
Command AddDetectCommand(CLI::App& program);
Command AddEvalCommand(CLI::App& program);
Command AddSynthCommand(CLI::App& program);
Command AddExperimentCommand(CLI::App& program);
Command AddCheckCommand(CLI::App& program);
Command AddReportCommand(CLI::App& program);
Command AddOverlayCommand(CLI::App& program);
Command AddPlotCommand(CLI::App& program);
Command AddExplainCommand(CLI::App& program);
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

// Checks that a number is finite and in [low, high].
template <typename Number>
CLI::Validator Within(Number low, Number high) {
  return {[range = CLI::Range(low, high)](std::string& text) {
            const std::string problem = range(text);
            return problem.empty() ? FiniteProblem(text) : problem;
          },
          ""};
}

// Adds flags and arguments to a command. `kind`: what help shows for the value.
struct FlagAdder {
  CLI::App& app;

  template <typename Value>
  CLI::Option* operator()(const char* name, Value& value, const char* kind,
                          const std::string& meaning) const {
    return app.add_option(name, value, meaning)->type_name(kind);
  }
};

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

// Add -q, and --threads with the number of CPUs as its default. Every long command has them.
void AddQuiet(CLI::App& app, bool& quiet);
void AddThreads(CLI::App& app, int& threads);
// The number of CPUs.
int DefaultThreads();
// Adds --seed, whose value is read exactly: the flag parser would wrap, saturate or read octal.
CLI::Option* AddSeed(CLI::App& app, std::optional<std::uint64_t>& seed, const char* meaning);

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

// A table of text, with columns aligned by spaces.
class TextTable {
 public:
  explicit TextTable(std::vector<std::string> header) : rows_{std::move(header)} {}

  // Appends a row, which must have as many cells as the header.
  void Add(std::vector<std::string> row);
  // Returns one line per row, the header first.
  std::vector<std::string> Lines() const;
  void Print(std::ostream& out) const;

 private:
  std::vector<std::vector<std::string>> rows_;
};

// A number for display, with four significant digits.
std::string ReadableNumber(double value);

// "1 frame/s", "12.5 frames/s".
std::string FrameRateText(double frames_per_s);

// Shows progress on stderr, with the rate and the time left: on a terminal in one line that is
// rewritten, otherwise in a line after every tenth of the work.
class Progress {
 public:
  // `unit`: what is counted.
  explicit Progress(bool quiet, std::string unit = "frames");
  ~Progress();  // erases the line on a terminal
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  // With another `stage` than before, prints its name and starts anew.
  void Report(std::size_t done, std::size_t total, const std::string& stage = "");
  // Prints one line, even if quiet.
  void Note(const std::string& line) const;
  // Report, for as long as this object exists.
  std::function<void(std::size_t, std::size_t)> Reporter();

 private:
  using Clock = std::chrono::steady_clock;

  // "3/8 jobs  2.0 jobs/s  2:30 min left"; slow rates are per minute.
  std::string Text(std::size_t done, std::size_t total) const;

  std::string unit_;
  bool quiet_;
  bool terminal_;
  std::string stage_;
  Clock::time_point start_ = Clock::now();  // of the stage
  std::size_t shown_tenths_ = 0;
};

// Prints "clustervo: <line>" on stderr, in place of a bar.
void PrintNotice(const std::string& line);

// Exit code of a command that was stopped by SIGINT or SIGTERM.
inline constexpr int kInterrupted = 130;

// While an instance exists, the first SIGINT and the first SIGTERM are only recorded; a second
// signal of the same kind ends the program.
class StopSignal {
 public:
  StopSignal();
  ~StopSignal();
  StopSignal(const StopSignal&) = delete;
  StopSignal& operator=(const StopSignal&) = delete;

  bool Requested() const;
};

// Every command obtains the places it writes to from these functions, before it does any work. Each
// function throws UsageError if the place, with links resolved, is a sequence or lies in one, lies
// in a folder where a suite keeps its runs, is one of the folders in `read`, or contains a file of
// `read` under a name that would be written. `names` and errors are those of OutputFolder.
OutputFolder OpenOutput(const std::filesystem::path& folder, const std::vector<std::string>& names,
                        const std::vector<std::filesystem::path>& read);

// For a file that the user named: checks that WriteOutputFile will be allowed to write it.
OutputFolder CheckOutputFile(const std::filesystem::path& file,
                             const std::vector<std::filesystem::path>& read);
// Writes the file completely or not at all, and creates its folder if necessary. Throws Error
// naming what is in the way.
void WriteOutputFile(const std::filesystem::path& file, const std::string& content,
                     const std::vector<std::filesystem::path>& read);

// Throws UsageError for a file that is there and does not begin like this.
void CheckOwnFile(const std::filesystem::path& file, const std::string& begins);

// For a folder that will become a sequence. It may replace a sequence, but not lie in one.
void CheckNewSequence(const std::filesystem::path& folder,
                      const std::vector<std::filesystem::path>& read);

// The folders from which a sequence is read.
std::vector<std::filesystem::path> FoldersOf(const Sequence& sequence);

// Throws UsageError if the output is or lies in a folder of `inputs`.
void CheckNotBelow(const std::vector<std::filesystem::path>& inputs,
                   const std::filesystem::path& output);

// Throws UsageError if the output of a run is the folder of a suite, or that of a suite the folder
// of a run or of a suite with another name. A plan.json that cannot be read counts as none.
void CheckPlaceOfRun(const std::filesystem::path& output);
void CheckPlaceOfSuite(const std::filesystem::path& output, const std::string& suite);

// A new folder in the system's folder for temporary files, removed by the destructor. The
// constructor also removes the folders of killed processes. Throws Error if the folder cannot be
// created.
class ScratchFolder {
 public:
  ScratchFolder();
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace cvo
