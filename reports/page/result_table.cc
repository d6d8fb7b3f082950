// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <optional>

#include "core/base/error.h"
#include "core/files/text/number.h"
#include "core/record/metric_catalogue.h"
#include "reports/page/page.h"
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
  std::string html =
      StrCat("<td class=\"number", cell.best ? " best" : "", cell.grey ? " grey" : "", "\"");
  if (number) html += StrCat(" data-value=\"", FormatDouble(*number), "\"");
  if (!cell.n.empty()) html += StrCat(" title=\"n: ", Escaped(cell.n), "\"");
  html += ">";
  if (cell.value.empty()) return html + "</td>";
  if (cell.best) html += "<span class=\"mark\">best</span> ";
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

}  // namespace

std::string ResultTable(const Table& table, const std::string& id) {
  TableTexts texts = MakeTexts(table);
  if (texts.any_best) texts.footnotes.insert(texts.footnotes.begin(), BestNote("best"));
  std::string html;
  for (std::size_t i = 0; i < texts.blocks.size(); ++i) html += BlockHtml(table, texts, i, id);
  return html +
         Folded("Notes: what each value is based on, and how values are compared",
                texts.footnotes) +
         Folded("Definitions of the columns", texts.definitions);
}

}  // namespace cvo::reports
