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

// A difference, with its sign and its unit.
std::string ChangeText(double value, const Column& column) {
  const std::string text = StrCat(value > 0.0 ? "+" : "", QuantityText(value, column));
  const bool share = ShownAs(column.metric, column.unit).is_share;
  return share ? text.substr(0, text.size() - 1) + "percentage points" : text;
}

// "0.05 to 0.07 m".
std::string RangeText(const Interval& interval, const Column& column) {
  const Shown shown = ShownAs(column.metric, column.unit);
  return StrCat(NumberText(shown.scale * interval.low), " to ",
                QuantityText(interval.high, column));
}

// A significant difference.
std::string FindingHtml(const std::string& name, const std::string& verdict, const Column& column,
                        const Difference& difference, const std::string& reference) {
  std::string text = StrCat(QuantityText(difference.value, column), " instead of ",
                            QuantityText(difference.reference_value, column), " with ", reference,
                            ": ", ChangeText(difference.difference, column));
  if (difference.interval) {
    text += StrCat(" (interval ", RangeText(*difference.interval, column), "; ", difference.pairs,
                   " pairs)");
  }
  return StrCat("<li class=\"", verdict, "\"><strong>", Escaped(name), "</strong> ",
                "<span class=\"verdict\">", verdict, "</span>: ", Escaped(text), ".</li>\n");
}

// "3 sequences (a, b and c)"; many values are only counted.
std::string ValuesText(const std::vector<PageRun>& runs, const std::string& key, const char* name) {
  constexpr std::size_t kNamed = 12;
  std::vector<std::string> values;  // in the order of the plan
  for (const PageRun& run : runs) AddOnce(KeyOf(run.run.planned, key), values);
  const std::string count = Counted(values.size(), name);
  return values.size() > kNamed ? count : StrCat(count, " (", Listed(values), ")");
}

std::string ComparedText(const PageContent& content, const Table& table) {
  std::vector<std::string> parts;
  for (const std::string& key : table.keys) {
    if (key == "sequence" || key == "family" || key == "variant") continue;
    parts.push_back(ValuesText(content.runs, key, "value") + " of " + key);
  }
  std::set<std::uint64_t> seeds;
  for (const PageRun& run : content.runs) seeds.insert(run.run.planned.seed);
  parts.insert(parts.begin(), {ValuesText(content.runs, "variant", "variant"),
                               ValuesText(content.runs, "sequence", "sequence")});
  parts.push_back(Counted(seeds.size(), "seed"));
  std::set<std::string> splits;
  for (const Row& row : table.rows) {
    if (!row.split.empty()) splits.insert("split " + row.split);
  }
  parts.insert(parts.end(), splits.begin(), splits.end());
  return Joined(parts, "; ") + ".";
}

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
    std::map<std::string, std::vector<std::string>> columns;  // by verdict
    std::map<std::string, std::string> found;                 // significant ones, by verdict
    for (std::size_t i = 0; i < row.cells.size(); ++i) {
      const auto& difference = row.cells[i].difference;
      if (!difference) continue;
      const Column& column = table.columns[i];
      const std::string name = NameOf(column, table);
      const std::string verdict = VerdictText(*difference, column.metric);
      columns[verdict].push_back(name);
      if (!difference->distinguishable) continue;
      found[verdict] += FindingHtml(name, verdict, column, *difference, reference);
    }
    if (columns.empty()) continue;
    const std::string counts = Joined(columns, ", ", [](const auto& of_verdict) {
      return StrCat(of_verdict.second.size(), " ", of_verdict.first);
    });
    html += Element("h3", StrCat(RowLabel(row), ": ", counts)) + "\n";
    if (!found.empty()) html += "<ul class=\"findings\">\n";
    for (const auto& [verdict, items] : found) html += items;
    if (!found.empty()) html += "</ul>\n";
    for (const auto& [verdict, names] : columns) {
      if (found.contains(verdict)) continue;
      html += StrCat("<p class=\"unclear\">", Capitalised(verdict), ": ", Escaped(Listed(names)),
                     ".</p>\n");
    }
  }
  return html;
}

std::string SummarySection(const PageContent& content) {
  std::string html = "<section id=\"summary\">\n<h2>Summary</h2>\n";
  if (!content.about.empty()) html += Element("p", content.about) + "\n";
  for (const std::string& problem : content.problems) {
    html += "<p class=\"problem\">" + Escaped(problem) + "</p>\n";
  }
  if (!content.table) return html + "</section>\n";
  const Table& table = *content.table;
  html += Element("p", ComparedText(content, table)) + "\n" + FactsHtml(content.variants);
  html += "<p>" + Escaped(JobsText(table.jobs)) + ".";
  if (!table.problems.empty()) html += " <a href=\"#missing\">What is missing, and why</a>.";
  html += "</p>\n";
  if (table.reference.empty()) {
    return html + "<p>No row is the reference, so no differences are reported.</p>\n</section>\n";
  }
  html += "<h2>Significant differences</h2>\n" + Element("p", RuleText(table.reference)) + "\n";
  const std::string findings = FindingsHtml(table, table.reference);
  html += findings.empty() ? "<p>There is nothing to compare yet.</p>\n" : findings;
  return html + "</section>\n";
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
