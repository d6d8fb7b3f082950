// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/cli/run/run_flags.h"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <thread>

#include "core/files/json/options_json.h"
#include "experiments/cli/output_file.h"

namespace cvo {

void RunFlags::AddTo(CLI::App& app) {
  app.add_option("--set", set, "set one option (see clustervo list options); can be repeated")
      ->type_name("PATH=VALUE")
      ->allow_extra_args(false);
  app.add_option("--config", config,
                 "JSON file with options as nested objects; --set takes precedence")
      ->type_name("FILE");
  AddThreads(app, threads);
  AddQuiet(app, quiet);
}

Options RunFlags::Resolve(const Options& defaults) const {
  CheckNoFolder("--config", config);
  return ResolveOptions<Options>(config, set, defaults);
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
