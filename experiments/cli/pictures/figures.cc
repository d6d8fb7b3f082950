// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <iostream>
#include <memory>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "core/files/text/closest_names.h"
#include "experiments/cli/command.h"
#include "experiments/cli/output_file.h"
#include "experiments/cli/pictures/render_figures.h"
#include "experiments/cli/reports/suite_table.h"
#include "reports/figure_files/paper_figure.h"
#include "reports/figures/suite/suite_figures.h"
#include "reports/tables/make_table.h"

namespace cvo {
namespace {

struct FigureFlags {
  std::string folder;
  std::string out;
  std::string format = "svg";
  std::string only;
};

void KeepOnly(const std::string& id, reports::SuiteDrawing& drawing) {
  std::vector<std::string> ids;
  for (const reports::Figure& figure : drawing.figures) ids.push_back(figure.id);
  if (std::find(ids.begin(), ids.end(), id) == ids.end()) {
    ThrowError("--only", StrCat("\"", id, "\"", DidYouMean(id, ids)),
               "one of: " + Joined(ids, ", "));
  }
  std::erase_if(drawing.figures, [&](const reports::Figure& figure) { return figure.id != id; });
}

std::vector<NamedContent> MakeFiles(const std::vector<reports::Figure>& figures,
                                    const std::string& format) {
  if (format != "json") return RenderFigures(figures, format);
  std::vector<NamedContent> files;
  for (const reports::Figure& figure : figures) {
    files.push_back({figure.id + ".json", reports::FigureJson(figure)});
  }
  return files;
}

int WriteFigures(const FigureFlags& flags) {
  const reports::Table table =
      reports::MakeTable(flags.folder, reports::ShippedReference(), DefaultOptions());
  reports::SuiteDrawing drawing =
      reports::SuiteFigures(reports::ReadSuiteData(flags.folder, table));
  if (!flags.only.empty()) KeepOnly(flags.only, drawing);
  const OutputFolder out = OpenOutput(flags.out, {}, {flags.folder});
  if (!drawing.figures.empty()) {
    const std::vector<NamedContent> files = MakeFiles(drawing.figures, flags.format);
    WriteFilesAtomically(out.path(), files);
    for (std::size_t i = 0; i < files.size(); ++i) {
      std::cout << (out.path() / files[i].name).string() << ": " << drawing.figures[i].title
                << '\n';
    }
  }
  if (flags.only.empty()) {
    for (const std::string& reason : drawing.not_drawn)
      std::cout << "not drawn: " << reason << '\n';
  }
  return 0;
}

}  // namespace

Command AddFiguresCommand(CLI::App& program) {
  CLI::App* app =
      program.add_subcommand("figures", "Export the figures of a suite as SVG, PDF or Plotly JSON");
  const auto flags = std::make_shared<FigureFlags>();
  app->add_option("DIR", flags->folder, "output folder of the suite")->type_name("")->required();
  app->add_option("-o,--output", flags->out, "output folder")->type_name("OUT")->required();
  app->add_option("--format", flags->format, "svg, pdf, or json (Plotly figure)")
      ->type_name("FORMAT")
      ->check(OneOf({"svg", "pdf", "json"}));
  app->add_option("--only", flags->only, "write only this figure, given by its file name")
      ->type_name("ID");
  app->footer(
      "The set of figures depends on the results: varied options, references, bodies with "
      "ground\ntruth, times. Figures that cannot be drawn are listed with the reason. SVG and PDF "
      "are\nrendered by Chromium (Debian's, or CLUSTERVO_BROWSER). The same results give "
      "byte-identical\nfiles.\n"
      "Example: clustervo figures results/ablation -o figures --format pdf");
  return {app, [flags] { return WriteFigures(*flags); }};
}

}  // namespace cvo
