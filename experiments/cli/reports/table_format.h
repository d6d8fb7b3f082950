// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "experiments/cli/command.h"
#include "reports/tables/table.h"

namespace cvo {

// How a table is printed, and where.
struct TableFormat {
  std::string format = "terminal";
  std::string output;   // a file; empty: standard output
  bool bare = false;    // LaTeX, HTML: only the table, for embedding in a document
  bool longer = false;  // CSV: one record per cell

  bool Terminal() const { return format == "terminal"; }
};

void AddTableFormat(CLI::App& app, TableFormat& format);

// Throws a command-line error if the flags do not go together.
void CheckTableFormat(const TableFormat& format);

// Prints the table, or writes it to its file, which must not be one of `read`, and reports the
// file's name. `after`: text that follows the table in the terminal format.
void OutputTable(const reports::Table& table, const TableFormat& format,
                 const std::vector<std::filesystem::path>& read, std::string after = "");

}  // namespace cvo
