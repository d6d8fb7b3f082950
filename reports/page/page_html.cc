// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <optional>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "core/files/sha256.h"
#include "core/files/text/number.h"
#include "core/files/text/utf8.h"
#include "core/record/metric_catalogue.h"
#include "reports/figures/figure_style.h"
#include "reports/page/page.h"
#include "reports/tables/table_texts.h"

namespace cvo::reports {
namespace {

// The hash by which a Content-Security-Policy names the only script that may run.
std::string ScriptSource() {
  const std::string hex = Sha256Hex(PageScript());
  std::string bytes;
  for (std::size_t i = 0; i < hex.size(); i += 2) {
    bytes += static_cast<char>(std::stoi(hex.substr(i, 2), nullptr, 16));
  }
  return "'sha256-" + Base64(bytes) + "'";
}

std::string TableSection(const PageContent& content) {
  std::string html = "<section id=\"table\">\n<h2>Table</h2>\n";
  if (!content.table) {
    return html + "<p class=\"problem\">There is no table: see above.</p>\n</section>\n";
  }
  html +=
      "<p>Each value is a mean, with its 95 % interval below it. A star marks a significant "
      "difference from the reference. Grey rows are published "
      "results of others, with their sources in the notes below; values in brackets are not "
      "comparable with ours. Select a heading to sort by it.</p>\n";
  return html + ResultTable(*content.table, "table") + "</section>\n";
}

// Emphasises the first sentence of a title, which says what is shown, over the rest, which says how
// it was measured.
std::string FigureHtml(const Figure& figure) {
  const std::size_t end = std::min(figure.title.find(". "), figure.title.size() - 1) + 1;
  ChartStyle style;
  style.css = false;
  return StrCat("<figure class=\"figure\" id=\"figure-", Escaped(figure.name), "\">\n<figcaption>",
                Element("strong", figure.title.substr(0, end)), Escaped(figure.title.substr(end)),
                Element("p", figure.caption),
                "</figcaption>\n<div class=\"scroll chart\" style=\"--part:",
                FormatGeneral(figure.chart.width, 4), "\">", ChartSvg(figure.chart, style),
                "</div>\n</figure>\n");
}

std::string FiguresSection(const PageContent& content) {
  std::string html = "<section id=\"figures\">\n<h2>Figures</h2>\n";
  if (content.drawing.figures.empty()) {
    html += "<p class=\"problem\">No figure could be made from these results.</p>\n";
  }
  for (const Figure& figure : content.drawing.figures) html += FigureHtml(figure);
  return html + "</section>\n";
}

// Without the script the image in the middle of the run is seen.
std::string PlayerHtml(const PageScene& scene, const std::string& name, std::size_t index) {
  std::string html = StrCat(
      "<details class=\"frames\" id=\"frames-", index, "\"", index == 1 ? " open" : "", ">\n",
      Element("summary", name),
      "\n<div class=\"player\" hidden><button type=\"button\">Play</button><input type=\"range\" "
      "min=\"0\" step=\"1\" aria-label=\"Frame\"></div>\n<figure>\n");
  for (std::size_t i = 0; i < scene.images.size(); ++i) {
    const PageImage& image = scene.images[i];
    html += StrCat("<img data-frame=\"", image.frame, "\" alt=\"", Escaped(image.alt), "\"",
                   i == scene.images.size() / 2 ? "" : " hidden", " src=\"data:image/jpeg;base64,",
                   Base64(image.jpeg), "\">\n");
  }
  return html + Element("figcaption", "Left image with what was estimated") +
         "\n</figure>\n</details>\n";
}

std::string FramesSection(const PageContent& content) {
  std::string html = "<section id=\"frames\">\n<h2>Frame by frame</h2>\n";
  std::vector<std::string> without;
  std::size_t shown = 0;
  for (const PageScene& scene : content.scenes) {
    const PlannedRun& run = content.runs[scene.run].planned;
    const std::string name =
        StrCat(KeyOf(run, "sequence"), ": ", KeyOf(run, "variant"), ", seed ", run.seed);
    if (!scene.images.empty()) html += PlayerHtml(scene, name, ++shown);
    if (!scene.no_images.empty()) without.push_back(StrCat(name, ": ", scene.no_images));
  }
  if (shown == 0) html += "<p class=\"problem\">No run can be shown.</p>\n";
  return html + ListHtml("Runs without images", without) + "</section>\n";
}

std::string MissingSection(const PageContent& content) {
  const std::vector<std::string> problems =
      content.table ? ProblemTexts(*content.table) : std::vector<std::string>();
  std::string html = ListHtml("Runs that failed, are missing or lost the camera", problems) +
                     ListHtml("Missing or unreadable files", content.missing) +
                     ListHtml("Not shown in figures", content.drawing.not_drawn);
  if (html.empty()) html = "<p>Nothing is missing.</p>\n";
  return "<section id=\"missing\">\n<h2>What is missing</h2>\n" + html + "</section>\n";
}

std::string OriginSection(const PageContent& content) {
  std::string html =
      "<section id=\"origin\">\n<h2>Origin of the numbers</h2>\n" + ListHtml("", content.origins);
  if (content.table) {
    html += Element("p", "Seeds: " + Joined(content.table->provenance.seeds, ", ")) + "\n";
  }
  return html + "</section>\n";
}

std::string Navigation() {
  const std::vector<Fact> parts = {
      {"summary", "Summary"},         {"table", "Table"},
      {"figures", "Figures"},         {"frames", "Frame by frame"},
      {"missing", "What is missing"}, {"origin", "Origin of the numbers"}};
  std::string html = "<nav aria-label=\"Parts of this page\"><ul>\n";
  for (const auto& [id, name] : parts) {
    html += StrCat("<li><a href=\"#", id, "\">", Escaped(name), "</a></li>\n");
  }
  return html + "</ul></nav>\n";
}

}  // namespace

std::string Escaped(std::string_view text) { return HtmlEscaped(Printable(text)); }

std::string Element(const std::string& tag, std::string_view text) {
  return "<" + tag + ">" + Escaped(text) + "</" + tag + ">";
}

std::string ListHtml(const std::string& heading, const std::vector<std::string>& texts) {
  if (texts.empty()) return "";
  std::string html = heading.empty() ? "<ul>\n" : Element("h3", heading) + "\n<ul>\n";
  for (const std::string& text : texts) html += Element("li", text) + "\n";
  return html + "</ul>\n";
}

std::string FactsHtml(const std::vector<Fact>& facts) {
  if (facts.empty()) return "";
  std::string html = "<dl class=\"facts\">\n";
  for (const auto& [name, value] : facts) html += Element("dt", name) + Element("dd", value) + "\n";
  return html + "</dl>\n";
}

std::string HtmlDocument(const std::string& title, const std::string& body) {
  return StrCat(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; img-src data: "
      "'self' file:; style-src 'unsafe-inline'; script-src ",
      ScriptSource(),
      "\">\n<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n",
      Element("title", title), "\n<style>", PageStyle(), ChartCss(), "</style>\n</head>\n<body>\n",
      body, "<p id=\"script-problem\" class=\"problem\" role=\"alert\" hidden></p>\n<script>",
      PageScript(), "</script>\n</body>\n</html>\n");
}

std::string PageHtml(const PageContent& content) {
  return HtmlDocument(
      content.title + ": ClusterVO-bench report",
      StrCat("<header>\n", Element("h1", content.title), "\n<p>Results of ClusterVO-bench</p>\n",
             Navigation(), "</header>\n<main>\n", SummarySection(content), TableSection(content),
             FiguresSection(content), FramesSection(content), MissingSection(content),
             OriginSection(content), "</main>\n"));
}

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
         Span("reason", cell.note) + "</td>";
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
  const TableTexts texts = MakeTexts(table);
  std::string html;
  for (std::size_t i = 0; i < texts.blocks.size(); ++i) html += BlockHtml(table, texts, i, id);
  return html +
         Folded("Notes: what each value is based on, and how values are compared",
                texts.footnotes) +
         Folded("Definitions of the columns", texts.definitions);
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
  return html + Element("p", "Differences are relative to " + table.reference + ".") +
         "\n</section>\n";
}

}  // namespace cvo::reports
