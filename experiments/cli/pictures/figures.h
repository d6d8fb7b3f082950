// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "reports/figures/suite_figures.h"

namespace cvo {

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
