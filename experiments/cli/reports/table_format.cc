// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/cli/reports/table_format.h"

#include <sys/ioctl.h>
#include <unistd.h>

#include <cstdio>
#include <iostream>

#include "experiments/cli/command.h"
#include "experiments/cli/output_file.h"
#include "reports/formats/table_csv.h"
#include "reports/formats/table_html.h"
#include "reports/formats/table_latex.h"
#include "reports/formats/table_text.h"

namespace cvo {
namespace {

// Characters per line of the terminal; 0 if unknown.
std::size_t TerminalWidth() {
  winsize size{};
  return ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 ? size.ws_col : 0;
}

std::string Rendered(const reports::Table& table, const TableFormat& format) {
  if (format.format == "markdown") return reports::TableMarkdown(table);
  if (format.format == "csv") {
    return format.longer ? reports::TableLongCsv(table) : reports::TableCsv(table);
  }
  if (format.format == "latex") {
    return format.bare ? reports::TableLatexBare(table) : reports::TableLatex(table);
  }
  if (format.format == "html") {
    return format.bare ? reports::TableHtml(table) : reports::TableHtmlPage(table);
  }
  if (!format.output.empty() || isatty(STDOUT_FILENO) == 0) {
    return reports::TableText(table, false);
  }
  return reports::TableText(table, true, TerminalWidth());
}

}  // namespace

void AddTableFormat(CLI::App& app, TableFormat& format) {
  app.add_option("--format", format.format, "output format of the table")
      ->type_name("NAME")
      ->check(OneOf({"terminal", "markdown", "csv", "latex", "html"}))
      ->capture_default_str();
  app.add_option("-o,--output", format.output,
                 "write the table to this file instead of printing it")
      ->type_name("FILE");
  app.add_flag("--bare", format.bare,
               "latex, html: only the table, for \\input or embedding in a page");
  app.add_flag("--long", format.longer, "csv: one record per cell, with all its fields");
}

void CheckTableFormat(const TableFormat& format) {
  if (format.bare && format.format != "latex" && format.format != "html") {
    throw CLI::ValidationError("--bare", "requires --format latex or html");
  }
  if (format.longer && format.format != "csv") {
    throw CLI::ValidationError("--long", "requires --format csv");
  }
}

void OutputTable(const reports::Table& table, const TableFormat& format,
                 const std::vector<std::filesystem::path>& read, std::string after) {
  const std::string text = Rendered(table, format);
  if (!format.Terminal()) after.clear();
  if (format.output.empty()) {
    std::cout.flush();
    std::fputs(text.c_str(), stdout);  // not std::cout: CleanOutput removes terminal codes
    std::cout << after;
    return;
  }
  WriteOutputFile(format.output, text + after, read);
  std::cout << "written: " << format.output << '\n';
}

}  // namespace cvo
