// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <string>
#include <vector>

#include "reports/tables/make_table.h"

namespace cvo {

// How a table is printed, and where.
struct TableFormat {
  std::string format = "terminal";
  std::string output;   // a file; empty: standard output
  bool longer = false;  // CSV: one record per cell

  // Adds --format, --output and --long.
  void AddTo(CLI::App& app);
  // Throws a command-line error if the flags do not go together.
  void Check() const;
};

// Prints the table, or writes it to its file, which must not be one of `read`, and reports the
// file's name. `after`: text that follows the table in the terminal format.
void OutputTable(const reports::Table& table, const TableFormat& format,
                 const std::vector<std::filesystem::path>& read, std::string after = "");

// The default values of the estimator's options, as nested JSON.
std::string DefaultOptions();

}  // namespace cvo
