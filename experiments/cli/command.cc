// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/cli/command.h"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <optional>
#include <thread>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "core/files/text/closest_names.h"
#include "core/files/text/number.h"
#include "core/files/text_file.h"
#include "experiments/record/build_identity.h"

namespace cvo {

Command Group(CLI::App& app, std::vector<Command> commands) {
  app.require_subcommand(1);
  return {&app, [commands = std::move(commands)] {
            for (const Command& command : commands) {
              if (command.app->parsed()) return command.run();
            }
            return 0;
          }};
}

std::string FiniteProblem(const std::string& text) {
  const std::optional<double> number = ParseDouble(text);
  return number ? "" : StrCat("found '", text, "', expected a finite number");
}

CLI::Validator OneOf(std::vector<std::string> names) {
  return {[names = std::move(names)](const std::string& text) -> std::string {
            if (std::find(names.begin(), names.end(), text) != names.end()) return "";
            return StrCat("found ", Quoted(text), DidYouMean(text, names), ", expected one of ",
                          Joined(names, ", "));
          },
          ""};
}

void RefuseFlags(const CLI::App& app, const std::vector<std::string>& flags,
                 const std::string& why) {
  for (const std::string& flag : flags) {
    const CLI::Option* option = app.get_option_no_throw(flag);
    if (option != nullptr && option->count() > 0) throw UsageError(StrCat(flag, ": ", why));
  }
}

std::string VersionText() {
  const BuildIdentity& build = ThisBuild();
  return StrCat("clustervo ", build.version, "\nbuild      ", build.identity, "\nestimator  ",
                build.estimator_sources, "\nevaluation ", build.evaluation_sources, "\ncommit     ",
                build.commit, "\ncompiler   ", build.compiler, ", ", build.build_type, ", ",
                build.flags, "\nlibraries  OpenCV ", build.libraries.opencv, ", Eigen ",
                build.libraries.eigen, "\nCPU level  ", build.cpu_level);
}

void CheckNoFolder(const char* flag, const std::string& file) {
  if (!std::filesystem::is_directory(file)) return;
  throw UsageError(StrCat(flag, ": found the folder ", file, ", expected a file"));
}

void AddQuiet(CLI::App& app, bool& quiet) {
  app.add_flag("-q,--quiet", quiet, "do not print progress to stderr");
}

int DefaultThreads() { return static_cast<int>(std::max(1U, std::thread::hardware_concurrency())); }

void AddThreads(CLI::App& app, int& threads) {
  threads = DefaultThreads();
  app.add_option(
         "--threads", threads,
         "total number of threads, which does not affect the results; default: number of CPUs")
      ->type_name("N")
      ->check(CLI::Range(1, 1024).description(""));
}

std::uint64_t ParseSeed(const std::string& text) {
  std::uint64_t seed = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), seed);
  if (error != std::errc{} || end != text.data() + text.size()) {
    throw CLI::ValidationError("--seed", "found '" + text + "', expected an integer in [0, 2^64)");
  }
  return seed;
}

}  // namespace cvo
