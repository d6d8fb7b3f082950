// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <string>
#include <vector>

#include "core/interface/options.h"

namespace cvo {

// Flags that control how an estimator runs, independent of its input.
struct RunFlags {
  std::string config;
  std::vector<std::string> set;
  int threads = 1;
  bool quiet = false;

  void AddTo(CLI::App& app);
  // Returns the defaults, overridden by --config and then by --set. Throws Error for an invalid
  // option.
  Options Resolve(const Options& defaults) const;
};

// Throws UsageError if a folder was given to a flag that takes a file.
void CheckNoFolder(const char* flag, const std::string& file);

// Add -q, and --threads with the number of CPUs as its default. Every long command has them.
void AddQuiet(CLI::App& app, bool& quiet);
void AddThreads(CLI::App& app, int& threads);
// The number of CPUs.
int DefaultThreads();

// Parses the value of --seed exactly: the flag parser itself would wrap, saturate or read octal.
std::uint64_t ParseSeed(const std::string& text);

}  // namespace cvo
