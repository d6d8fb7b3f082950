// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <map>
#include <set>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "reports/figures/figure_style.h"
#include "reports/page/page.h"
#include "reports/statistics/estimate.h"
#include "reports/tables/cells.h"
#include "reports/tables/table_texts.h"

namespace cvo::reports {
namespace {

std::string RuleText(const std::string& reference) {
  return StrCat(
      "Differences are relative to ", reference,
      ", over the pairs that both have. A difference is considered significant if its 95 % "
      "interval does not contain 0, its p-value, corrected for the number of comparisons in the "
      "table (Holm), is below 0.05, and there are at least ",
      kMinPairs,
      " pairs. Intervals cover the variation over scenes; where a row has only one scene, "
      "over its bodies.");
}

}  // namespace

std::string FindingsHtml(const Table& table, const std::string& reference) {
  std::string html;
  for (const Row& row : table.rows) {
    for (std::size_t i = 0; i < row.cells.size(); ++i) {
      const auto& difference = row.cells[i].difference;
      if (!difference || !difference->distinguishable) continue;
      const Column& column = table.columns[i];
      const bool higher = ShownAs(column.metric, column.unit).higher_is_better;
      const char* verdict = (difference->difference > 0.0) == higher ? "better" : "worse";
      html += StrCat("<li class=\"", verdict, "\"><strong>", Escaped(RowLabel(row)),
                     "</strong>: ", Escaped(NameOf(column, table)), " <span class=\"verdict\">",
                     verdict, "</span>, ", Escaped(QuantityText(difference->value, column)),
                     " instead of ", Escaped(QuantityText(difference->reference_value, column)),
                     " with ", Escaped(reference), ".</li>\n");
    }
  }
  return html.empty() ? "<p>No difference is significant.</p>\n"
                      : StrCat("<ul class=\"findings\">\n", html, "</ul>\n");
}

std::string SummarySection(const PageContent& content) {
  std::string html = "<section id=\"summary\">\n<h2>Summary</h2>\n";
  if (!content.about.empty()) html += Element("p", content.about) + "\n";
  for (const std::string& problem : content.problems) {
    html += "<p class=\"problem\">" + Escaped(problem) + "</p>\n";
  }
  if (!content.table) return html + "</section>\n";
  const Table& table = *content.table;
  html += FactsHtml(content.variants) + "<p>" + Escaped(JobsText(table.jobs)) + ".";
  if (!table.problems.empty()) html += " <a href=\"#missing\">What is missing, and why</a>.";
  html += "</p>\n";
  if (table.reference.empty()) {
    return html + "<p>No row is the reference, so no differences are reported.</p>\n</section>\n";
  }
  html += "<h2>Significant differences</h2>\n" + Element("p", RuleText(table.reference)) + "\n";
  return html + FindingsHtml(table, table.reference) + "</section>\n";
}

std::string ComparisonSection(const PageContent& content) {
  if (content.compared_with.empty()) return "";
  const std::string& other = content.compared_with;
  std::string html =
      StrCat("<section id=\"comparison\">\n", Element("h2", "Compared with " + other), "\n");
  if (!content.comparison) {
    return html +
           "<p class=\"problem\">The two results cannot be compared: see above.</p>\n</section>\n";
  }
  html += Element("p", StrCat("Differences between these results and those of ", other,
                              ". Runs are paired by row, sequence and seed. ", RuleText(other)));
  return StrCat(html, "\n", FindingsHtml(*content.comparison, other),
                ResultTable(*content.comparison, "comparison-table"), "</section>\n");
}

}  // namespace cvo::reports
