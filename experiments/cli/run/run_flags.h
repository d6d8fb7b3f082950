// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <string>
#include <vector>

#include "core/interface/options.h"

namespace cvo {

// The flags that say how an estimator runs, whatever it runs on.
struct RunFlags {
  std::string config;
  std::vector<std::string> set;
  int threads = 1;
  bool quiet = false;

  void AddTo(CLI::App& app);
  // The defaults, --config, then --set. Throws Error for an option that cannot be.
  Options Resolve(const Options& defaults) const;
};

// Throws UsageError for a folder where the flag means a file.
void CheckNoFolder(const char* flag, const std::string& file);

// -q, and --threads with the number of CPUs as its default: what every long command has.
void AddQuiet(CLI::App& app, bool& quiet);
void AddThreads(CLI::App& app, int& threads);
// The number of CPUs.
int DefaultThreads();

// "--seed N" exactly as written: the parser itself would wrap, saturate or read octal.
std::uint64_t ParseSeed(const std::string& text);

}  // namespace cvo
