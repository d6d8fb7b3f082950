// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <map>

#include "core/base/error.h"
#include "reports/figures/numbers.h"
#include "reports/page/html.h"
#include "reports/page/page_parts.h"
#include "reports/page/quantity.h"
#include "reports/tables/comparisons.h"

namespace cvo::reports {
namespace {

struct RowFindings {
  std::vector<std::string> better, worse, other;        // significant differences, as HTML
  std::vector<std::string> noise, same;                 // labels of columns
  std::map<std::size_t, std::vector<std::string>> few;  // undecided, by the number of pairs
};

std::string Verdict(const std::optional<bool>& better) {
  if (!better) return "differs";
  return *better ? "better" : "worse";
}

// The label of a column, with its unit if another column has the same label.
std::string NameOf(const Column& column, const Table& table) {
  const auto count =
      std::count_if(table.columns.begin(), table.columns.end(),
                    [&](const Column& other) { return other.label == column.label; });
  return count > 1 ? StrCat(column.label, " (", column.unit, ")") : column.label;
}

std::string FindingHtml(const Column& column, const std::string& name, const Difference& difference,
                        const std::string& reference) {
  const std::string verdict = Verdict(IsBetter(column.metric, difference.difference));
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

RowFindings FindingsOf(const Row& row, const Table& table, const std::string& reference) {
  RowFindings found;
  for (std::size_t i = 0; i < row.cells.size(); ++i) {
    const auto& difference = row.cells[i].difference;
    if (!difference) continue;
    const Column& column = table.columns[i];
    const std::string name = NameOf(column, table);
    if (difference->distinguishable) {
      const auto better = IsBetter(column.metric, difference->difference);
      auto& list = !better ? found.other : *better ? found.better : found.worse;
      list.push_back(FindingHtml(column, name, *difference, reference));
    } else if (difference->difference == 0.0) {
      found.same.push_back(name);
    } else if (difference->pairs < kMinPairs) {
      found.few[difference->pairs].push_back(name);
    } else {
      found.noise.push_back(name);
    }
  }
  return found;
}

bool OnlySame(const RowFindings& found) {
  return found.better.empty() && found.worse.empty() && found.other.empty() &&
         found.noise.empty() && found.few.empty() && !found.same.empty();
}

std::string CountText(std::size_t count, const char* one, const char* many) {
  return StrCat(count, " ", count == 1 ? one : many);
}

std::string Headline(const RowFindings& found) {
  std::vector<std::string> parts;
  if (!found.better.empty()) parts.push_back(StrCat("better in ", found.better.size()));
  if (!found.worse.empty()) parts.push_back(StrCat("worse in ", found.worse.size()));
  if (!found.other.empty()) parts.push_back(StrCat("different in ", found.other.size()));
  if (parts.empty() && found.noise.empty() && !found.few.empty()) {
    return UndecidedText(found.few.rbegin()->first);
  }
  if (parts.empty()) return "no significant difference";
  std::size_t all = found.better.size() + found.worse.size() + found.other.size() +
                    found.noise.size() + found.same.size();
  for (const auto& [pairs, labels] : found.few) all += labels.size();
  return StrCat(Listed(parts), " of ", CountText(all, "metric", "metrics"));
}

std::string InconclusiveHtml(const std::string& what, const std::vector<std::string>& labels) {
  if (labels.empty()) return "";
  return StrCat("<p class=\"unclear\">", what, ": ", Escaped(Listed(labels)), ".</p>\n");
}

}  // namespace

std::string FindingsHtml(const Table& table, const std::string& reference) {
  std::string html;
  std::vector<std::string> unchanged;
  for (const Row& row : table.rows) {
    const RowFindings found = FindingsOf(row, table, reference);
    if (OnlySame(found)) {
      unchanged.push_back(RowLabel(row));
      continue;
    }
    const bool any = !found.better.empty() || !found.worse.empty() || !found.other.empty();
    if (!any && found.noise.empty() && found.few.empty()) continue;
    html += StrCat("<h3>", Escaped(StrCat(RowLabel(row), ": ", Headline(found))), "</h3>\n");
    if (any) html += "<ul class=\"findings\">\n";
    for (const auto* list : {&found.worse, &found.better, &found.other}) {
      for (const std::string& item : *list) html += item;
    }
    if (any) html += "</ul>\n";
    html += InconclusiveHtml("Not significant", found.noise);
    for (const auto& [pairs, labels] : found.few) {
      html += InconclusiveHtml(Capitalised(UndecidedText(pairs)), labels);
    }
    html += InconclusiveHtml("The same", found.same);
  }
  if (!unchanged.empty()) {
    html += Element("p", "The same in every metric: " + Listed(unchanged) + ".") + "\n";
  }
  return html;
}

}  // namespace cvo::reports
