// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <sys/ioctl.h>
#include <unistd.h>

#include <cstdio>
#include <iostream>
#include <memory>

#include "core/base/lists.h"
#include "core/files/atomic_file.h"
#include "core/files/json/options_json.h"
#include "core/files/text_file.h"
#include "core/interface/options.h"
#include "experiments/cli/command.h"
#include "experiments/cli/output.h"
#include "experiments/cli/reports/reports.h"
#include "experiments/cli/terminal.h"
#include "reports/runs/suite_times.h"
#include "reports/tables/make_table.h"
#include "reports/tables/table_texts.h"

namespace cvo {
namespace {

namespace fs = std::filesystem;

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
  if (format.format == "latex") return reports::TableLatex(table);
  if (!format.output.empty() || isatty(STDOUT_FILENO) == 0) {
    return reports::TableText(table, false);
  }
  return reports::TableText(table, true, TerminalWidth());
}

// Makes and prints the table of a suite's output folder. In the terminal format, also writes
// table.json and table.md there, unless `compared_with` names another reference row than the
// suite's (see MakeTable). Returns 0 if all jobs that can run have run, 1 if some failed or have
// not run yet. Throws Error if there is no plan.
int OutputSuiteTable(const fs::path& folder, const TableFormat& format,
                     const std::string& compared_with) {
  CheckNoCollection(folder);
  const reports::Table table =
      reports::MakeTable(folder, reports::ShippedReference(), DefaultOptions(), compared_with);
  const bool is_kept = format.format == "terminal" && compared_with.empty();
  if (is_kept) {
    WriteFilesAtomically(folder, {{"table.md", reports::TableMarkdown(table)},
                                  {"table.json", reports::TableJson(table)}});
  }
  OutputTable(table, format, {folder / "plan.json"});
  if (is_kept) {
    std::cout << (format.output.empty() ? "\n" : "")
              << "written: " << (folder / "table.json").string()
              << " and table.md, with the definitions of the columns\n";
  }
  return reports::IsComplete(table) ? 0 : kIncomplete;
}

struct TableFlags {
  std::string folder;
  std::string from;
  std::string reference;
  bool times = false;
  TableFormat format;
};

// Medians over the runs of a row; stages are means over frames.
int PrintTimes(const std::string& folder) {
  CheckNoCollection(folder);
  const reports::SuiteTimes times = reports::ReadSuiteTimes(folder);
  const std::vector<std::vector<std::string>> rows = reports::TimesTable(times);
  TextTable table(rows.front());
  for (std::size_t i = 1; i < rows.size(); ++i) table.Add(rows[i]);
  table.Print(std::cout);
  std::cout << "machine: " << Joined(times.machines, "; ") << '\n';
  return 0;
}

int OutputTableOf(const TableFlags& flags) {
  if (flags.times) return PrintTimes(flags.folder);
  if (flags.from.empty()) return OutputSuiteTable(flags.folder, flags.format, flags.reference);
  OutputTable(reports::ReadTable(ReadFileBytes(flags.from), flags.from), flags.format,
              {flags.from});
  return 0;
}

}  // namespace

void TableFormat::AddTo(CLI::App& app) {
  app.add_option("--format", format, "output format of the table")
      ->type_name("NAME")
      ->check(OneOf({"terminal", "markdown", "csv", "latex"}))
      ->capture_default_str();
  app.add_option("-o,--output", output, "write the table to this file instead of printing it")
      ->type_name("FILE");
  app.add_flag("--long", longer, "csv: one record per cell, with all its fields");
}

void TableFormat::Check() const {
  if (longer && format != "csv") throw CLI::ValidationError("--long", "requires --format csv");
}

void OutputTable(const reports::Table& table, const TableFormat& format,
                 const std::vector<fs::path>& read, std::string after) {
  const std::string text = Rendered(table, format);
  if (format.format != "terminal") after.clear();
  if (format.output.empty()) {
    std::cout.flush();
    std::fputs(text.c_str(), stdout);  // not std::cout: CleanOutput removes terminal codes
    std::cout << after;
    return;
  }
  WriteOutputFile(format.output, text + after, read);
  std::cout << "written: " << format.output << '\n';
}

std::string DefaultOptions() {
  Options options;
  return DumpJson(OptionsToJson(OptionLeaves(options)));
}

Command AddExperimentTableCommand(CLI::App& experiment) {
  CLI::App* app = experiment.add_subcommand(
      "table", "Print and write the table of a suite's results so far, with confidence intervals");
  const auto flags = std::make_shared<TableFlags>();
  CLI::Option* folder =
      app->add_option("DIR", flags->folder, "output folder of the suite")->type_name("");
  app->add_option("--from", flags->from, "table.json to read instead of DIR, without the results")
      ->type_name("FILE")
      ->excludes(folder);
  app->add_option("--reference", flags->reference,
                  "row that the others are compared with, a variant or key=value; default: the "
                  "suite's; with it, DIR is not written to")
      ->type_name("ROW")
      ->needs(folder);
  flags->format.AddTo(*app);
  app->add_flag("--times", flags->times,
                "instead print frames per second and the time of each stage of the runs")
      ->needs(folder);
  app->footer(
      "Every row states how many of its runs it is based on. With format terminal, "
      "DIR/table.json\nand DIR/table.md are written too; csv has all digits; latex is a tabular "
      "for \\input.\nExit code 1 if jobs failed or have not run yet; absent sequences are "
      "listed.\nTimes are medians over the runs of a row, of stages means over frames. They are "
      "comparable only\nif every run had the machine to itself, as in a suite with timed_threads, "
      "which runs one job at a\ntime without cached features.\n"
      "Examples:\n"
      "  clustervo experiment table results/ablation --format latex -o ablation.tex\n"
      "  clustervo experiment table results/timing --times");
  app->callback([app, flags] {
    flags->format.Check();
    if (flags->folder.empty() && flags->from.empty()) throw CLI::RequiredError("DIR or --from");
    if (!flags->times) return;
    RefuseFlags(*app, {"--reference", "--format", "--output", "--long"},
                "does not apply with --times");
  });
  return {app, [flags] { return OutputTableOf(*flags); }};
}

}  // namespace cvo
