// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// What the page tells of a table: its values, its differences, and which of them are significant.
#include <optional>

#include "core/base/error.h"
#include "core/files/text/number.h"
#include "core/record/metric_catalogue.h"
#include "reports/figures/figure_style.h"
#include "reports/page/page.h"
#include "reports/statistics/estimate.h"
#include "reports/tables/table_texts.h"

namespace cvo::reports {
namespace {

std::string Span(const char* kind, const std::string& text) {
  return text.empty() ? "" : StrCat("<span class=\"", kind, "\">", Escaped(text), "</span>");
}

// The number behind a cell, for sorting.
std::optional<double> NumberOf(const Table& table, const TextLine& line, std::size_t column,
                               bool differences) {
  if (line.theirs != nullptr) {
    const ReferenceCell* cell = line.theirs->Find(table.columns[column]);
    return cell != nullptr ? std::optional(cell->value) : std::nullopt;
  }
  const Cell& cell = line.row->cells[column];
  if (!differences) return cell.value;
  return cell.difference ? std::optional(cell.difference->difference) : std::nullopt;
}

std::string CellHtml(const CellText& cell, const std::optional<double>& number) {
  std::string html = StrCat("<td class=\"number", cell.grey ? " grey" : "", "\"");
  if (number) html += StrCat(" data-value=\"", FormatDouble(*number), "\"");
  if (!cell.n.empty()) html += StrCat(" title=\"n: ", Escaped(cell.n), "\"");
  html += ">";
  if (cell.value.empty()) return html + "</td>";
  html += Span("value", cell.Shown());
  if (cell.distinguishable) html += "<abbr class=\"star\" title=\"significant\">*</abbr>";
  return html + Span("small", cell.interval) + Span("small", cell.percent) +
         Span("small", cell.percent_interval) + Span("reason", cell.note) + "</td>";
}

// The keys of a row are header cells; the other texts at the left are not. Figures of others stay
// with the row above them.
std::string LineHtml(const Table& table, const TextLine& line, bool differences) {
  std::string html = StrCat("<tr class=\"", line.grey ? "grey" : "",
                            line.theirs != nullptr && line.row != nullptr ? " below" : "", "\">");
  for (std::size_t i = 0; i < line.texts.size(); ++i) {
    const bool name = i < table.keys.size() && !line.texts[i].empty();
    html += StrCat(name ? "<th scope=\"row\">" : "<td>", Escaped(line.texts[i]),
                   name ? "</th>" : "</td>");
  }
  for (std::size_t i = 0; i < line.cells.size(); ++i) {
    html += CellHtml(line.cells[i], NumberOf(table, line, i, differences));
  }
  return html + "</tr>\n";
}

std::string BlockHtml(const Table& table, const TableTexts& texts, std::size_t index,
                      const std::string& id) {
  const TextBlock& block = texts.blocks[index];
  const bool differences = index > 0;
  std::string html =
      StrCat("<div class=\"scroll\" tabindex=\"0\">\n<table class=\"results\" id=\"", Escaped(id),
             differences ? "-differences" : "-values", "\">\n",
             Element("caption", differences ? block.heading : texts.about), "\n<thead><tr>");
  for (const std::string& name : texts.text_header) {
    html += StrCat("<th scope=\"col\">", Escaped(name), "</th>");
  }
  for (std::size_t i = 0; i < texts.columns.size(); ++i) {
    const ColumnText& column = texts.columns[i];
    const MetricEntry* entry = FindEntry(table.columns[i].metric);
    html +=
        StrCat("<th scope=\"col\" class=\"number\"",
               entry != nullptr ? StrCat(" title=\"", Escaped(entry->meaning), "\"") : "", ">",
               Escaped(column.label),
               Span("unit", column.unit.empty() ? "" : StrCat(" [", column.unit, "]")), "</th>");
  }
  html += "</tr></thead>\n<tbody>\n";
  for (const TextLine& line : block.lines) html += LineHtml(table, line, differences);
  return html + "</tbody>\n</table>\n</div>\n";
}

std::string Folded(const std::string& summary, const std::vector<std::string>& lines) {
  if (lines.empty()) return "";
  return StrCat("<details class=\"notes\">", Element("summary", summary), "\n", ListHtml("", lines),
                "</details>\n");
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

std::string ResultTable(const Table& table, const std::string& id) {
  const TableTexts texts = MakeTexts(table);
  std::string html;
  for (std::size_t i = 0; i < texts.blocks.size(); ++i) html += BlockHtml(table, texts, i, id);
  return html +
         Folded("Notes: what each value is based on, and how values are compared",
                texts.footnotes) +
         Folded("Definitions of the columns", texts.definitions);
}

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

}  // namespace cvo::reports
