// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <map>
#include <set>

#include "core/base/error.h"
#include "reports/figures/numbers.h"
#include "reports/page/html.h"
#include "reports/page/page_parts.h"

namespace cvo::reports {
namespace {

constexpr std::size_t kShownJobs = 200;

std::string RunText(const SuiteRun& run) {
  std::vector<std::string> keys;
  for (const auto& [key, value] : run.planned.keys) {
    if (value != "none") keys.push_back(key + " " + value);
  }
  keys.push_back(StrCat("seed ", run.planned.seed));
  return Listed(keys);
}

std::string JobsWithoutValue(const std::vector<PageRun>& runs) {
  std::string html;
  std::size_t count = 0;
  for (const char* state : {"failed", "lost", "not run", "no data"}) {
    for (const PageRun& run : runs) {
      if (run.run.state != state || ++count > kShownJobs) continue;
      html += StrCat("<li><strong>", state, "</strong> ", Escaped(RunText(run.run)));
      if (!run.run.message.empty()) html += ": " + Escaped(run.run.message);
      if (!run.run.log.empty()) html += " (log: " + Escaped(run.run.log) + ")";
      html += "</li>\n";
    }
  }
  if (html.empty()) return "";
  if (count > kShownJobs) html += StrCat("<li>and ", count - kShownJobs, " more</li>\n");
  return "<h3>Runs that failed, are missing or lost the camera</h3>\n<ul>\n" + html + "</ul>\n";
}

// Texts that apply to several names, each listed once with those names.
class NamesPerText {
 public:
  void Add(const std::string& text, const std::string& name) {
    if (names_by_text_[text].insert(name).second && names_by_text_[text].size() == 1)
      order_.push_back(text);
  }
  std::string Html(const std::string& heading) const {
    std::string html;
    for (const std::string& text : order_) {
      const std::set<std::string>& sorted = names_by_text_.at(text);
      std::vector<std::string> names(sorted.begin(), sorted.end());
      html += StrCat("<li>", Escaped(text), " (", Escaped(Listed(names)), ")</li>\n");
    }
    return html.empty() ? "" : StrCat("<h3>", heading, "</h3>\n<ul>\n", html, "</ul>\n");
  }

 private:
  std::vector<std::string> order_;
  std::map<std::string, std::set<std::string>> names_by_text_;
};

std::string CellsWithoutValue(const Table& table) {
  NamesPerText cells;
  for (const Row& row : table.rows) {
    for (std::size_t i = 0; i < row.cells.size(); ++i) {
      if (row.cells[i].present) continue;
      const std::string why = row.cells[i].message;
      cells.Add(StrCat(table.columns[i].label, ": ", why.empty() ? "no value" : why),
                RowLabel(row));
    }
  }
  return cells.Html("Cells without a value");
}

std::string UnreadableFiles(const PageContent& content) {
  NamesPerText files;
  for (const PageRun& run : content.runs) {
    for (const std::string& file : run.origin.missing) files.Add(file, RunText(run.run));
  }
  for (const PageScene& scene : content.scenes) {
    const std::string name = RunText(content.runs[scene.run].run);
    for (const std::string& file : scene.detail.missing) files.Add(file, name);
    if (!scene.no_images.empty()) files.Add("images: " + scene.no_images, name);
  }
  return files.Html("Missing or unreadable files");
}

}  // namespace

std::string MissingSection(const PageContent& content) {
  std::string html = JobsWithoutValue(content.runs);
  if (content.table) {
    html += CellsWithoutValue(*content.table);
    if (!content.table->notes.empty()) {
      html += "<h3>Notes for comparison</h3>\n<ul>\n";
      for (const std::string& note : content.table->notes) html += Element("li", note) + "\n";
      html += "</ul>\n";
    }
  }
  html += UnreadableFiles(content);
  if (!content.drawing.not_drawn.empty()) {
    html += "<h3>Not shown in figures</h3>\n<ul>\n";
    for (const std::string& line : content.drawing.not_drawn) html += Element("li", line) + "\n";
    html += "</ul>\n";
  }
  if (html.empty()) html = "<p>Nothing is missing.</p>\n";
  return "<section id=\"missing\">\n<h2>What is missing</h2>\n" + html + "</section>\n";
}

}  // namespace cvo::reports
