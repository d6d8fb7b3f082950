// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <iostream>
#include <map>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "core/files/json/json_record.h"
#include "core/files/text/number.h"
#include "core/record/run_summary.h"
#include "core/record/suite_runs.h"
#include "experiments/cli/command.h"
#include "experiments/cli/reports/reports.h"
#include "experiments/cli/suite/run_suite.h"
#include "experiments/suite/suite.h"
#include "reports/page/page.h"
#include "reports/runs/run_detail.h"
#include "reports/tables/make_table.h"

namespace cvo {
namespace {

namespace fs = std::filesystem;

std::string Link(const std::string& path, const std::string& text) {
  return StrCat("<a href=\"", reports::Escaped(path), "\">", reports::Escaped(text), "</a>");
}

std::string PlainTable(const std::vector<std::string>& columns,
                       const std::vector<std::vector<std::string>>& rows) {
  std::string html = "<div class=\"scroll\" tabindex=\"0\"><table>\n<thead><tr>";
  for (const std::string& column : columns) html += reports::Element("th", column);
  html += "</tr></thead>\n<tbody>\n";
  for (const std::vector<std::string>& row : rows) {
    html += "<tr>";
    for (const std::string& cell : row) html += reports::Element("td", cell);
    html += "</tr>\n";
  }
  return html + "</tbody>\n</table></div>\n";
}

class CollectionRun {
 public:
  CollectionRun(const Collection& collection, const SuiteRunFlags& flags)
      : collection_(collection), flags_(flags), root_(flags.suite.output) {}

  int Run() {
    CheckPlaceOfSuite(root_, collection_.name);
    const OutputFolder output = OpenOutput(root_, {"index.html", "figures/"}, {});
    int worst = 0;
    CheckSuites();
    for (const CollectionSection& section : collection_.sections) {
      if (section.suite.empty() || ran_.contains(section.suite)) continue;
      const int code = RunOne(section.suite);
      if (code == kInterrupted) return code;
      worst = std::max(worst, code);
    }
    WriteFilesAtomically(root_, {{"index.html", Page()}});
    std::cout << "written: " << (root_ / "index.html").string() << '\n';
    return worst;
  }

 private:
  // Checks all suites before the first one runs. A wrong name is an error in the collection's file,
  // a wrong value of an override is a usage error.
  void CheckSuites() const {
    for (const CollectionSection& section : collection_.sections) {
      if (section.suite.empty()) continue;
      const Suite suite = LoadSuite(section.suite);
      LoadNamed(section.suite, [&] { return Override(suite, flags_.suite.overrides); });
    }
  }

  fs::path FolderOf(const std::string& suite) const { return root_ / SuiteFolderName(suite); }

  SuiteRunFlags FlagsOf(const std::string& suite) const {
    SuiteRunFlags flags = flags_;
    flags.suite.suite = suite;
    flags.suite.output = FolderOf(suite).string();
    return flags;
  }

  // A suite without any sequence on this disk has a plan, which says so, and no runs.
  int RunOne(const std::string& suite) {
    const SuiteRunFlags flags = FlagsOf(suite);
    if (!flags.quiet) std::cerr << "suite " << SuiteFolderName(suite) << '\n';
    std::string& problem = ran_[suite];
    int code = 0;
    try {
      code = RunSuite(flags);
    } catch (const NoSequence& error) {
      problem = error.what();
      std::cout << problem << '\n';
    }
    return code;
  }

  std::string Page() {
    std::string contents;
    std::string sections;
    for (std::size_t i = 0; i < collection_.sections.size(); ++i) {
      const CollectionSection& section = collection_.sections[i];
      const std::string id = StrCat("section-", i + 1);
      std::string state;
      sections +=
          StrCat("<section id=\"", id, "\">\n", SectionHtml(section, id, state), "</section>\n");
      contents += StrCat("<li>", Link("#" + id, section.title), state, "</li>\n");
    }
    return reports::HtmlDocument(collection_.name,
                                 StrCat(reports::Element("h1", collection_.name), "\n",
                                        reports::Element("p", collection_.about), "\n<nav><ol>\n",
                                        contents, "</ol></nav>\n", sections));
  }

  // `state` becomes what the table of contents says about data that are not on this disk.
  std::string SectionHtml(const CollectionSection& section, const std::string& id,
                          std::string& state) const {
    std::string html = reports::Element("h2", section.title) + "\n";
    for (const std::string& text : section.text) html += reports::Element("p", text) + "\n";
    if (!section.columns.empty()) html += PlainTable(section.columns, section.rows);
    if (!section.suite.empty()) html += SuiteHtml(section, id, state);
    for (const CollectionFigure& figure : section.figures) html += PicturesHtml(figure);
    return html;
  }

  std::string SuiteHtml(const CollectionSection& section, const std::string& id,
                        std::string& state) const {
    const fs::path folder = FolderOf(section.suite);
    const reports::Table table =
        reports::MakeTable(folder, reports::ShippedReference(), DefaultOptions());
    std::vector<std::string> missing;
    for (const reports::Problem& problem : table.problems) {
      if (problem.state != "no data") continue;
      AddOnce(StrCat(problem.sequence, ": ", problem.message), missing);
    }
    const std::string& problem = ran_.at(section.suite);
    state = !problem.empty() ? ": not on this disk" : !missing.empty() ? ": in part" : "";
    std::string html;
    if (!problem.empty()) {
      html += reports::Element("p", "No table: " + problem) + "\n";
    } else {
      html += section.times ? TimesHtml(folder) : reports::ResultTable(table, id + "-table");
    }
    html += reports::ListHtml("Not on this disk", missing);
    if (!state.empty() && !section.data.empty()) {
      html += reports::Element("p", "Get it: " + section.data) + "\n";
    }
    if (!problem.empty()) return html;
    WriteReport({.folder = folder.string(), .no_images = true});
    return html + StrCat("<p>",
                         Link(SuiteFolderName(section.suite) + "/report/index.html",
                              "Figures, and run by run"),
                         "</p>\n");
  }

  static std::string TimesHtml(const fs::path& folder) {
    const reports::SuiteTimes times = reports::ReadSuiteTimes(folder);
    std::vector<std::vector<std::string>> rows = times.table;
    const std::vector<std::string> columns = rows.front();
    rows.erase(rows.begin());
    return reports::Element("p", "Here: " + Joined(times.machines, "; ") + ".") + "\n" +
           PlainTable(columns, rows);
  }

  std::string PicturesHtml(const CollectionFigure& figure) const {
    const std::string name = StrCat(SuiteFolderName(figure.suite), "-", figure.sequence);
    std::string html;
    for (const int frame : figure.frames) {
      const std::string folder = StrCat("figures/", name, "-", frame);
      const std::string what = StrCat(figure.sequence, ", ", figure.variants, ", frame ", frame);
      try {
        DrawOverlays({.suite = FolderOf(figure.suite).string(),
                      .sequence = figure.sequence,
                      .variants = figure.variants,
                      .output = (root_ / folder).string(),
                      .frame = frame,
                      .quiet = true});
        for (const auto& file : fs::directory_iterator(root_ / folder)) {
          html += StrCat("<figure><img src=\"",
                         reports::Escaped(folder + "/" + file.path().filename().string()),
                         "\" alt=\"", reports::Escaped(what), "\">",
                         reports::Element("figcaption", what), "</figure>\n");
        }
      } catch (const Error& error) {
        html += reports::Element("p", StrCat("No picture of ", what, ": ", error.what())) + "\n";
      }
    }
    return html;
  }

  const Collection& collection_;
  const SuiteRunFlags& flags_;
  fs::path root_;
  std::map<std::string, std::string> ran_;  // why a suite has no runs; empty if it has
};

}  // namespace

int RunCollection(const Collection& collection, const SuiteRunFlags& flags) {
  return CollectionRun(collection, flags).Run();
}

}  // namespace cvo
