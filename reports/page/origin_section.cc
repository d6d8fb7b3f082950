// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <map>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "core/files/text/escape.h"
#include "reports/figures/numbers.h"
#include "reports/formats/table_html.h"
#include "reports/page/html.h"
#include "reports/page/page_parts.h"
#include "reports/web/assets.h"

namespace cvo::reports {
namespace {

std::string FactsHtml(const std::vector<Fact>& facts) {
  std::string html = "<dl class=\"facts\">";
  for (const auto& [name, value] : facts) html += Element("dt", name) + Element("dd", value);
  return html + "</dl>\n";
}

// Lists each distinct set of facts once, with the number of runs it applies to.
std::string FactsWithRunCounts(const std::vector<PageRun>& runs,
                               std::vector<Fact> RunOrigin::*facts, const char* heading) {
  using Count = std::pair<std::vector<Fact>, std::size_t>;
  std::vector<Count> counted;
  for (const PageRun& run : runs) {
    const std::vector<Fact>& of_run = run.origin.*facts;
    if (!of_run.empty()) ++FindOrAdd(counted, &Count::first, {of_run, 0}).second;
  }
  std::string html = StrCat("<h3>", heading, "</h3>\n");
  if (counted.empty()) html += "<p>Not known.</p>\n";
  for (const auto& [of_runs, count] : counted) {
    html += StrCat("<p>", count, count == 1 ? " run:" : " runs:", "</p>\n") + FactsHtml(of_runs);
  }
  return html;
}

std::string OptionsHtml(const Provenance& provenance) {
  std::string html = "<h3>Options with values other than the default</h3>\n";
  if (provenance.options.empty()) return html + "<p>None.</p>\n";
  html += "<ul>\n";
  for (const ChangedOption& option : provenance.options) {
    html += StrCat("<li><code>", Escaped(option.path), "</code>: ", Escaped(Listed(option.values)));
    if (!option.default_value.empty()) {
      html += StrCat(" (default ", Escaped(option.default_value), ")");
    }
    html += "</li>\n";
  }
  return html + "</ul>\n";
}

}  // namespace

std::string OriginSection(const PageContent& content) {
  std::string html = "<section id=\"origin\">\n<h2>Origin of the numbers</h2>\n";
  html += FactsWithRunCounts(content.runs, &RunOrigin::build, "Program");
  html += FactsWithRunCounts(content.runs, &RunOrigin::machine, "Machine");
  if (content.table) html += OptionsHtml(content.table->provenance);
  return html + "</section>\n";
}

std::string LicenceSection() {
  return "<section id=\"licences\">\n<details><summary>Licences of components included in this "
         "page</summary>\n<p>Charts are drawn with Plotly.js:</p>\n<pre>" +
         HtmlEscaped(PlotlyLicence()) + "</pre>\n</details>\n</section>\n";
}

}  // namespace cvo::reports
