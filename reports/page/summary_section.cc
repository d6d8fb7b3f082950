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

// The columns in which a row differs from its reference, by VerdictText.
struct RowFindings {
  std::map<std::string, std::vector<std::string>> names;
  std::map<std::string, std::string> items;  // HTML of the significant ones
};

RowFindings FindingsOf(const Row& row, const Table& table, const std::string& reference) {
  RowFindings found;
  for (std::size_t i = 0; i < row.cells.size(); ++i) {
    const auto& difference = row.cells[i].difference;
    if (!difference) continue;
    const Column& column = table.columns[i];
    const std::string name = NameOf(column, table);
    const std::string verdict = VerdictText(*difference, column.metric);
    found.names[verdict].push_back(name);
    if (!difference->distinguishable) continue;
    found.items[verdict] += FindingHtml(name, verdict, column, *difference, reference);
  }
  return found;
}

std::string Headline(const RowFindings& found) {
  std::vector<std::string> parts;
  std::size_t all = 0;
  for (const auto& [verdict, names] : found.names) {
    all += names.size();
    if (!found.items.contains(verdict)) continue;
    parts.push_back(StrCat(verdict == "differs" ? "different" : verdict, " in ", names.size()));
  }
  if (!parts.empty()) return StrCat(Listed(parts), " of ", Counted(all, "metric"));
  const std::string& last = found.names.rbegin()->first;
  const bool undecided = last.starts_with("undecided") && !found.names.contains("not significant");
  return undecided ? last : "no significant difference";
}

std::string RowHtml(const RowFindings& found, const std::string& label) {
  std::string html = Element("h3", StrCat(label, ": ", Headline(found))) + "\n";
  if (!found.items.empty()) html += "<ul class=\"findings\">\n";
  for (const char* verdict : {"worse", "better", "differs"}) {
    if (found.items.contains(verdict)) html += found.items.at(verdict);
  }
  if (!found.items.empty()) html += "</ul>\n";
  for (const auto& [verdict, names] : found.names) {
    if (found.items.contains(verdict)) continue;
    html += StrCat("<p class=\"unclear\">", Capitalised(verdict), ": ", Escaped(Listed(names)),
                   ".</p>\n");
  }
  return html;
}

constexpr std::size_t kNamed = 12;  // any more are only counted

// The values of a key, in the order of the plan.
std::vector<std::string> ValuesOf(const std::vector<PageRun>& runs, const std::string& key) {
  std::vector<std::string> values;
  for (const PageRun& run : runs) AddOnce(KeyOf(run.run.planned, key), values);
  return values;
}

std::string Named(const std::vector<std::string>& values) {
  if (values.size() <= kNamed) return Listed(values);
  std::vector<std::string> first(values.begin(), values.begin() + kNamed);
  first.push_back(StrCat(values.size() - kNamed, " more"));
  return Listed(first);
}

std::string ComparedText(const PageContent& content, const Table& table) {
  std::string text;
  for (const std::string& key : table.keys) {
    if (key == "sequence" || key == "family") continue;
    const std::vector<std::string> values = ValuesOf(content.runs, key);
    const std::string counted = key == "variant"
                                    ? Counted(values.size(), "variant")
                                    : StrCat(Counted(values.size(), "value"), " of ", key);
    text += StrCat(text.empty() ? "Compares " : ", ", counted, " (", Named(values), ")");
  }
  std::set<std::uint64_t> seeds;
  for (const PageRun& run : content.runs) seeds.insert(run.run.planned.seed);
  const std::vector<std::string> sequences = ValuesOf(content.runs, "sequence");
  std::set<std::string> splits;
  for (const Row& row : table.rows) {
    if (!row.split.empty()) splits.insert(row.split);
  }
  return StrCat(text.empty() ? "On " : text + " on ", Counted(sequences.size(), "sequence"), " (",
                Named(sequences), sequences.size() == 1 ? ") with " : "), each with ",
                Counted(seeds.size(), "seed"), ".",
                splits.empty() ? "" : " Split: ", Listed({splits.begin(), splits.end()}),
                splits.empty() ? "" : ".");
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
  std::vector<std::string> unchanged;
  for (const Row& row : table.rows) {
    const RowFindings found = FindingsOf(row, table, reference);
    if (found.names.empty()) continue;
    if (found.names.size() == 1 && found.names.contains("the same")) {
      unchanged.push_back(RowLabel(row));
    } else {
      html += RowHtml(found, RowLabel(row));
    }
  }
  if (!unchanged.empty()) {
    html += Element("p", "The same in every metric: " + Listed(unchanged) + ".") + "\n";
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
