// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// clustervo experiment table, and the figures of a suite for clustervo plot.
#include <algorithm>
#include <iostream>
#include <memory>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "core/files/atomic_file.h"
#include "core/files/text/closest_names.h"
#include "core/files/text_file.h"
#include "experiments/cli/command.h"
#include "experiments/cli/reports/reports.h"
#include "experiments/runner/run_job.h"
#include "experiments/suite/engine.h"
#include "reports/runs/run_detail.h"
#include "reports/tables/make_table.h"
#include "reports/tables/table_texts.h"

namespace cvo {
namespace {

namespace fs = std::filesystem;

std::string Rendered(const reports::Table& table, const TableFormat& format) {
  if (format.format == "markdown") {
    return format.all ? reports::TableMarkdown(table) : reports::ShortMarkdown(table);
  }
  if (format.format == "csv") return reports::TableCsv(table);
  if (format.format == "latex") return reports::TableLatex(table);
  return format.all ? reports::TableListing(table) : reports::TableText(table);
}

// Makes and prints the table of a suite's output folder, with the rows of others. In the terminal
// format, also writes table.json and table.md there, unless there are others or `compared_with`
// names another reference row than the suite's (see MakeTable). Returns 0 if all jobs that can run
// have run, 1 if some failed or have not run yet. Throws Error if there is no plan.
int OutputSuiteTable(const std::vector<std::string>& folders, const TableFormat& format,
                     const std::string& compared_with) {
  const fs::path folder = folders.front();
  const std::vector<fs::path> beside(folders.begin() + 1, folders.end());
  const reports::Table table = reports::MakeTable(folder, reports::ShippedReference(),
                                                  DefaultOptions(), compared_with, beside);
  const bool is_kept = format.format == "terminal" && compared_with.empty() && beside.empty();
  if (is_kept) {
    WriteFilesAtomically(folder, {{"table.md", reports::TableMarkdown(table)},
                                  {"table.json", reports::TableJson(table)}});
  }
  std::vector<fs::path> read;
  for (const std::string& one : folders) read.push_back(fs::path(one) / "plan.json");
  OutputTable(table, format, read);
  if (is_kept) {
    std::cout << "written: " << (folder / "table.json").string() << " and table.md\n";
  }
  return reports::IsComplete(table) ? 0 : kIncomplete;
}

struct TableFlags {
  std::vector<std::string> folders;
  std::string reference;
  bool times = false;
  TableFormat format;
};

// Medians over the runs of a row; stages are means over frames.
int PrintTimes(const std::string& folder) {
  const reports::SuiteTimes times = reports::ReadSuiteTimes(folder);
  TextTable table(times.table.front());
  for (std::size_t i = 1; i < times.table.size(); ++i) table.Add(times.table[i]);
  table.Print(std::cout);
  std::cout << "machine: " << Joined(times.machines, "; ") << '\n';
  return 0;
}

int OutputTableOf(const TableFlags& flags) {
  if (!flags.times) return OutputSuiteTable(flags.folders, flags.format, flags.reference);
  if (flags.folders.size() > 1) throw UsageError("--times: found several DIR, expected one");
  return PrintTimes(flags.folders.front());
}

}  // namespace

void TableFormat::AddTo(CLI::App& app) {
  const FlagAdder add{app};
  add("--format", format, "NAME", "output format of the table")
      ->check(OneOf({"terminal", "markdown", "csv", "latex"}))
      ->capture_default_str();
  add("-o,--output", output, "FILE", "write the table to this file instead of printing it");
}

void OutputTable(const reports::Table& table, const TableFormat& format,
                 const std::vector<fs::path>& read, std::string after) {
  const std::string text = Rendered(table, format);
  if (format.format != "terminal") after.clear();
  if (format.output.empty()) {
    std::cout << text << after;
    return;
  }
  CheckOwnFile(format.output, text.substr(0, text.find('\n')));
  WriteOutputFile(format.output, text + after, read);
  std::cout << "written: " << format.output << '\n';
}

std::string DefaultOptions() { return DumpJson(ResolvedOptions({})); }

Command AddExperimentTableCommand(CLI::App& experiment) {
  CLI::App* app = experiment.add_subcommand(
      "table", "Print and write the table of a suite's results so far, with confidence intervals");
  const FlagAdder add{*app};
  const auto flags = std::make_shared<TableFlags>();
  add("DIR", flags->folders, "",
      "output folder of the suite; with others, such as copies of somebody else's: their rows too, "
      "named after their folder")
      ->required()
      ->expected(-1);
  add("--reference", flags->reference, "ROW",
      "row that the others are compared with, a variant or key=value; default: the "
      "suite's; with it, or with several DIR, nothing is written there");
  flags->format.AddTo(*app);
  app->add_flag("--all", flags->format.all,
                "print every column with its intervals and differences, and all notes");
  app->add_flag("--times", flags->times,
                "instead print frames per second and the time of each stage of the runs");
  app->footer(
      "Prints what fits on a screen, and writes DIR/table.json and DIR/table.md with the rest. Csv "
      "has all\ndigits; markdown has the columns of the screen with intervals; latex is a tabular "
      "for \\input.\nExit code 1 if jobs failed or have not "
      "run yet; absent sequences are "
      "listed.\nTimes are medians over the runs of a row, of stages means over frames. They are "
      "comparable only\nif every run had the machine to itself, as in a suite with timed_threads, "
      "which runs one job at a\ntime without cached features.\n"
      "Examples:\n"
      "  clustervo experiment table results/ablation --format latex -o ablation.tex\n"
      "  clustervo experiment table results/timing --times");
  app->callback([app, flags] {
    if (!flags->times) return;
    RefuseFlags(*app, {"--reference", "--format", "--output", "--all"},
                "does not apply with --times");
  });
  return {app, [flags] { return OutputTableOf(*flags); }};
}

namespace {

// The date in the PDF is fixed, so that the same figure gives the same bytes.
std::string ToPdf(const std::string& svg) {
  constexpr int kNotFound = 127;
  const ScratchFolder scratch;
  const std::string file = (scratch.path() / "figure.svg").string();
  WriteFileBytes(file, svg);
  const Captured made =
      Capture({"/usr/bin/env", "SOURCE_DATE_EPOCH=946684800", "rsvg-convert", "-f", "pdf", file},
              [](const Captured&) { return false; });
  if (made.exit_code == kNotFound) {
    ThrowError("pdf", "no rsvg-convert in PATH", "it (Debian: apt install librsvg2-bin), or svg");
  }
  if (made.exit_code != 0 || !made.out.starts_with("%PDF-")) {
    ThrowError("rsvg-convert", StrCat("exit code ", made.exit_code, ", ", Quoted(made.err)),
               "a PDF");
  }
  return made.out;
}

void KeepOnly(const std::string& name, reports::SuiteFigures& drawn) {
  std::vector<std::string> names;
  for (const reports::Figure& figure : drawn.figures) names.push_back(figure.name);
  if (std::find(names.begin(), names.end(), name) == names.end()) {
    ThrowError("--only", StrCat("\"", name, "\"", DidYouMean(name, names)),
               "one of: " + Joined(names, ", "));
  }
  std::erase_if(drawn.figures, [&](const auto& figure) { return figure.name != name; });
  drawn.not_drawn.clear();
}

}  // namespace

void AddChartStyle(CLI::App& app, reports::ChartStyle& style) {
  const FlagAdder add{app};
  add("--width-mm", style.width_mm, "MM", "width of a full figure")
      ->check(Within(60.0, 1000.0))
      ->capture_default_str();
  add("--font-pt", style.font_size_pt, "PT", "size of the font")
      ->check(Within(4.0, 40.0))
      ->capture_default_str();
  app.add_flag_callback(
      "--no-title", [&style] { style.texts = false; }, "without title and caption");
}

std::string FigureFile(const reports::Figure& figure, const reports::ChartStyle& style,
                       const std::string& format) {
  reports::Chart chart = figure.chart;
  if (style.texts) {
    chart.title = figure.title;
    chart.caption = figure.caption;
  }
  const std::string svg = reports::ChartSvg(chart, style);
  return format == "pdf" ? ToPdf(svg) : svg;
}

int WriteFigures(const SuiteFigureFlags& flags) {
  const reports::Table table =
      reports::MakeTable(flags.folder, reports::ShippedReference(), DefaultOptions());
  reports::SuiteFigures drawn =
      reports::MakeSuiteFigures(reports::ReadSuiteData(flags.folder, table));
  if (!flags.only.empty()) KeepOnly(flags.only, drawn);
  const OutputFolder out = OpenOutput(flags.output, {}, {flags.folder});
  std::vector<NamedContent> files;
  for (const reports::Figure& figure : drawn.figures) {
    files.push_back(
        {figure.name + "." + flags.format, FigureFile(figure, flags.style, flags.format)});
  }
  if (!files.empty()) WriteFilesAtomically(out.path(), files);
  for (std::size_t i = 0; i < files.size(); ++i) {
    std::cout << (out.path() / files[i].name).string() << ": " << drawn.figures[i].title << '\n';
  }
  for (const std::string& reason : drawn.not_drawn) std::cout << "not drawn: " << reason << '\n';
  return 0;
}

}  // namespace cvo
