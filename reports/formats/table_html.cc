// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/formats/table_html.h"

#include <optional>

#include "core/base/error.h"
#include "core/files/text/number.h"
#include "core/files/text/utf8.h"
#include "reports/results/metric_catalogue.h"
#include "reports/tables/table_texts.h"

namespace cvo::reports {
namespace {

std::string Attribute(const char* name, const std::string& value) {
  return StrCat(" ", name, "=\"", HtmlEscaped(value), "\"");
}

std::string Span(const char* kind, const std::string& text) {
  return text.empty() ? "" : StrCat("<span class=\"", kind, "\">", HtmlEscaped(text), "</span>");
}

// The numbers behind a cell, for sorting.
struct Numbers {
  std::optional<double> value;
  std::optional<Interval> interval;
  std::string match;  // of a published figure
};

Numbers NumbersOf(const Table& table, const TextLine& line, std::size_t column, bool differences) {
  if (line.reference) {
    const std::vector<ReferenceRow>& others =
        line.row ? table.rows[*line.row].reference : table.others;
    const auto& cell = others[*line.reference].cells[column];
    if (!cell) return {};
    return {cell->value, std::nullopt, NameOf(cell->match)};
  }
  const Cell& cell = table.rows[*line.row].cells[column];
  if (!differences) {
    if (!cell.present) return {};
    return {cell.value, cell.interval, ""};
  }
  if (!cell.difference) return {};
  return {cell.difference->difference, cell.difference->interval, ""};
}

std::string Place(const TextLine& line) {
  std::string place;
  if (line.row) place += Attribute("data-row", StrCat(*line.row));
  if (line.reference) place += Attribute("data-reference", StrCat(*line.reference));
  return place;
}

std::string ClassesOf(const CellText& cell) {
  return StrCat("number", cell.best ? " best" : "", cell.distinguishable ? " distinguishable" : "",
                cell.grey ? " grey" : "", cell.value == "-" ? " missing" : "");
}

// Keeps the digits aligned at the right edge: "best" precedes them, and the star overhangs.
std::string ValueHtml(const CellText& cell) {
  std::string html = Span("value", cell.Shown());
  if (cell.best) html = "<span class=\"mark\">best</span> <strong>" + html + "</strong>";
  if (cell.distinguishable) {
    html += "<abbr class=\"star\" title=\"distinguishable from noise\">*</abbr>";
  }
  return html;
}

std::string CellHtml(const Table& table, const TextLine& line, std::size_t column,
                     bool differences) {
  const CellText& cell = line.cells[column];
  const Numbers numbers = NumbersOf(table, line, column, differences);
  std::string html = "<td" + Attribute("class", ClassesOf(cell)) + Place(line);
  html += Attribute("data-column", StrCat(column));
  if (numbers.value) html += Attribute("data-value", FormatDouble(*numbers.value));
  if (numbers.interval) {
    html += Attribute("data-low", FormatDouble(numbers.interval->low)) +
            Attribute("data-high", FormatDouble(numbers.interval->high)) +
            Attribute("data-interval", Printable(numbers.interval->meaning));
  }
  if (!numbers.match.empty()) html += Attribute("data-match", numbers.match);
  if (!cell.n.empty()) html += Attribute("title", "n: " + cell.n);
  html += ">";
  if (cell.value.empty()) return html + "</td>";
  return html + ValueHtml(cell) + Span("interval", cell.interval) + Span("percent", cell.percent) +
         Span("interval", cell.percent_interval) + Span("n", cell.units) +
         Span("reason", cell.note) + "</td>";
}

// The keys of a row are header cells; the other texts at the left are not.
std::string LineHtml(const Table& table, const TextLine& line, bool differences) {
  std::string html = "<tr" + Place(line);
  html +=
      StrCat(" class=\"", line.reference ? "reference" : "ours", line.grey ? " grey" : "", "\">");
  for (std::size_t i = 0; i < line.texts.size(); ++i) {
    const bool name = i < table.keys.size() && !line.texts[i].empty();
    html += name ? "<th scope=\"row\">" : "<td>";
    html += HtmlEscaped(line.texts[i]);
    html += name ? "</th>" : "</td>";
  }
  for (std::size_t i = 0; i < line.cells.size(); ++i) {
    html += CellHtml(table, line, i, differences);
  }
  return html + "</tr>\n";
}

std::string HeaderHtml(const Table& table, const TableTexts& texts) {
  std::string html = "<thead><tr>";
  for (const std::string& name : texts.text_header) {
    html += "<th scope=\"col\">" + HtmlEscaped(name) + "</th>";
  }
  for (std::size_t i = 0; i < texts.columns.size(); ++i) {
    const std::string& metric = table.columns[i].metric;
    const MetricEntry* rule = FindEntry(metric);
    html += "<th scope=\"col\" class=\"number\"" + Attribute("data-column", StrCat(i)) +
            Attribute("data-metric", Printable(metric));
    if (rule) html += Attribute("data-better", rule->higher_is_better() ? "higher" : "lower");
    html += StrCat(">", HtmlEscaped(texts.columns[i].label));
    const std::string& unit = texts.columns[i].unit;
    if (!unit.empty()) html += StrCat(" ", Span("unit", StrCat("[", unit, "]")));
    html += "</th>";
  }
  return html + "</tr></thead>\n";
}

std::string BlockHtml(const Table& table, const TableTexts& texts, std::size_t index,
                      const std::string& id) {
  const TextBlock& block = texts.blocks[index];
  const bool differences = index > 0;
  const std::string caption = StrCat(id, differences ? "-differences" : "-values");
  std::string html = "<div class=\"cvo-scroll\" role=\"region\" tabindex=\"0\"" +
                     Attribute("aria-labelledby", caption) + ">\n";
  html += StrCat("<table class=\"", differences ? "cvo-differences" : "cvo-values", "\">\n");
  html += "<caption" + Attribute("id", caption) + "><span class=\"cvo-caption\">";
  html += differences ? HtmlEscaped(block.heading)
                      : Span("cvo-title", texts.title) + " " + Span("cvo-about", texts.about);
  html += "</span></caption>\n" + HeaderHtml(table, texts) + "<tbody>\n";
  for (const TextLine& line : block.lines) html += LineHtml(table, line, differences);
  return html + "</tbody>\n</table>\n</div>\n";
}

std::string ListHtml(const char* kind, const std::vector<std::string>& lines) {
  if (lines.empty()) return "";
  std::string html = StrCat("<ul class=\"", kind, "\">\n");
  for (const std::string& line : lines) html += "<li>" + HtmlEscaped(line) + "</li>\n";
  return html + "</ul>\n";
}

}  // namespace

std::string TableHtml(const Table& table, const std::string& id) {
  TableTexts texts = MakeTexts(table);
  if (texts.any_best) texts.footnotes.insert(texts.footnotes.begin(), BestNote("best"));
  std::string html = "<section class=\"cvo-table\"" + Attribute("id", id) + ">\n";
  for (std::size_t i = 0; i < texts.blocks.size(); ++i) html += BlockHtml(table, texts, i, id);
  html += "<div class=\"cvo-notes\">\n" + ListHtml("cvo-footnotes", texts.footnotes);
  if (!texts.definitions.empty()) {
    html += "<p>What the columns are:</p>\n" + ListHtml("cvo-definitions", texts.definitions);
  }
  return html + "</div>\n</section>\n";
}

}  // namespace cvo::reports
