// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

// What the commands that show results offer each other and clustervo experiment run.

#include <CLI/CLI.hpp>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "reports/figures/suite_figures.h"
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

struct ReportFlags {
  std::string folder;
  std::vector<std::string> runs = {};  // on one sequence, instead of a suite's folder
  std::string out = {};                // empty: the subfolder "report"
  std::string against = {};
  int every = 0;
  bool no_images = false;
  bool all_images = false;
};

// Writes the page of a suite's results. Returns 1 if a whole section could not be made, else 0.
int WriteReport(const ReportFlags& flags);

struct OverlayFlags {
  std::vector<std::string> runs = {};
  std::string suite = {};
  std::string sequence = {};
  std::string variants = "full";
  std::optional<std::uint64_t> seed = {};
  std::string output = {};
  int frame = -1;
  std::string frames = {};
  int every = 1;
  double scale = 1.0;
  std::string labels = {};
  bool sheet = false;
  bool video = false;
  bool no_images = false;
  bool no_inset = false;
  bool quiet = false;
};

// Draws runs on their images. Returns the exit code. Throws Error.
int DrawOverlays(const OverlayFlags& flags);

// The flags --width, --font and --font-size.
void AddChartStyle(CLI::App& app, reports::ChartStyle& style);

// The content of a file with the figure, its title and its caption. `format` is "svg" or "pdf",
// which rsvg-convert makes. Throws Error if that is not in PATH, or fails.
std::string FigureFile(const reports::Figure& figure, const reports::ChartStyle& style,
                       const std::string& format);

struct SuiteFigureFlags {
  std::string folder;  // of the suite
  std::string output;  // a folder
  std::string format = "svg";
  std::string only;  // the name of a figure; empty: all
  reports::ChartStyle style;
};

// Writes the figures of a suite, and prints their titles and why others were not drawn. Returns 0.
int WriteFigures(const SuiteFigureFlags& flags);

}  // namespace cvo
