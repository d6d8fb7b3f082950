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
  bool bare = false;    // of LaTeX and HTML the table alone, to be put into a document
  bool longer = false;  // of CSV one record per cell

  bool Terminal() const { return format == "terminal"; }
};

void AddTableFormat(CLI::App& app, TableFormat& format);

// Throws an error of the command line where flags do not go together.
void CheckTableFormat(const TableFormat& format);

// Prints the table or writes it to its file, which must not be one of `read`, and says so. `after`:
// what follows it in a terminal.
void OutputTable(const reports::Table& table, const TableFormat& format,
                 const std::vector<std::filesystem::path>& read, std::string after = "");

}  // namespace cvo
