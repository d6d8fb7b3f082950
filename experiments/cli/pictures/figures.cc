// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <iostream>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "core/files/text/closest_names.h"
#include "core/files/text_file.h"
#include "experiments/cli/output.h"
#include "experiments/cli/reports/reports.h"
#include "experiments/jobs/engine.h"
#include "reports/tables/make_table.h"

namespace cvo {
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
  app.add_option("--width", style.width_mm, "width of a full figure, in mm")
      ->type_name("MM")
      ->check(CLI::Range(60.0, 1000.0).description(""))
      ->capture_default_str();
  app.add_option("--font", style.font, "font families, in order of preference")
      ->type_name("NAMES")
      ->capture_default_str();
  app.add_option("--font-size", style.font_size_pt, "size of the font, in pt")
      ->type_name("PT")
      ->check(CLI::Range(4.0, 40.0).description(""))
      ->capture_default_str();
}

std::string FigureFile(const reports::Figure& figure, const reports::ChartStyle& style,
                       const std::string& format) {
  reports::Chart chart = figure.chart;
  chart.title = figure.title;
  chart.caption = figure.caption;
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
