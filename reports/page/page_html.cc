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
#include "reports/page/page.h"
#include "reports/tables/table_texts.h"

namespace cvo::reports {
namespace {

using Texts = std::vector<std::string>;

// Returns <tag attributes>text</tag>.
std::string Element(const std::string& tag, std::string_view text, const char* attributes = "") {
  return StrCat("<", tag, attributes, ">", Escaped(text), "</", tag, ">");
}

// A heading, if it is not empty, and one item for each text; empty if there is none.
std::string ListHtml(const std::string& heading, const Texts& texts) {
  if (texts.empty()) return "";
  std::string html = heading.empty() ? "<ul>\n" : Element("h3", heading) + "\n<ul>\n";
  for (const std::string& text : texts) html += Element("li", text) + "\n";
  return html + "</ul>\n";
}

// A folded part of the page; empty if there is nothing in it.
std::string Folded(const std::string& id, const std::string& summary, const std::string& html) {
  if (html.empty()) return "";
  return StrCat("<details id=\"", id, "\">", Element("summary", summary), "\n", html,
                "</details>\n");
}

std::string ProblemHtml(const std::string& text) {
  return Element("p", text, " class=\"problem\"") + "\n";
}

// The hash by which a Content-Security-Policy names the only script that may run.
std::string ScriptSource() {
  const std::string hex = Sha256Hex(PageScript());
  std::string bytes;
  for (std::size_t i = 0; i < hex.size(); i += 2) {
    bytes += static_cast<char>(std::stoi(hex.substr(i, 2), nullptr, 16));
  }
  return "'sha256-" + Base64(bytes) + "'";
}

// What the suite compared.
std::string Summary(const PageContent& content) {
  std::string html = "<section id=\"summary\">\n";
  if (!content.about.empty()) html += Element("p", content.about) + "\n";
  for (const std::string& problem : content.problems) html += ProblemHtml(problem);
  if (!content.table) return html + ProblemHtml("There is no table: see above.") + "</section>\n";
  const Table& table = *content.table;
  html += Element("p", StrCat(JobsText(table.jobs), ". ",
                              table.reference.empty()
                                  ? "No row is the reference, so no differences are reported."
                                  : "Differences are relative to " + table.reference + ".")) +
          "\n";
  std::string variants;
  for (const auto& [name, meaning] : content.variants) {
    variants += Element("dt", name) + Element("dd", meaning) + "\n";
  }
  if (!variants.empty()) variants = "<dl class=\"facts\">\n" + variants + "</dl>\n";
  return html + Folded("variants", "What the variants are", variants) + "</section>\n";
}

// Two numbers of a cell may be on two lines.
std::string ShortCell(const char* begin, const std::string& text, const char* end) {
  const std::size_t slash = std::min(text.find('/'), text.size());
  return StrCat(begin, Escaped(text.substr(0, slash)), slash < text.size() ? "/<wbr>" : "",
                Escaped(text.substr(std::min(slash + 1, text.size()))), end);
}

std::string ShortTableHtml(const Table& table) {
  const ShortTable texts = MakeShortTable(table);
  std::string html =
      "<div class=\"scroll\" tabindex=\"0\"><table class=\"short\">\n<thead><tr><th></th>";
  for (const std::string& heading : texts.headings) {
    html += ShortCell("<th scope=\"col\" class=\"number\">", heading, "</th>");
  }
  html += "</tr></thead>\n<tbody>\n";
  for (const auto& row : texts.rows) {
    html += "<tr>" + Element("th", row.front(), " scope=\"row\"");
    for (std::size_t i = 1; i < row.size(); ++i) {
      html += ShortCell("<td class=\"number\">", row[i], "</td>");
    }
    html += "</tr>\n";
  }
  html += "</tbody></table></div>\n<p class=\"notes\">";
  return html + Joined(texts.notes, "<br/>\n", Escaped) + "</p>\n";
}

// Emphasises the first sentence of a title, which says what is shown, over the rest, which says how
// it was measured. The chart is drawn twice, for desktops and for phones.
std::string FigureHtml(const Figure& figure) {
  constexpr double kPhoneMm = 84.0;
  const std::size_t end = std::min(figure.title.find(". "), figure.title.size() - 1) + 1;
  ChartStyle style;
  style.css = false;
  const std::string wide = ChartSvg(figure.chart, style);
  style.width_mm = kPhoneMm / figure.chart.width;
  return StrCat("<figure id=\"figure-", Escaped(figure.name), "\">\n<figcaption>",
                Element("strong", figure.title.substr(0, end)), Escaped(figure.title.substr(end)),
                end < figure.title.size() ? "." : "", " ", Escaped(figure.caption),
                "</figcaption>\n<div class=\"scroll chart wide\" style=\"",
                "--part:", FormatGeneral(figure.chart.width, 4), "\">", wide,
                "</div>\n<div class=\"chart phone\">", ChartSvg(figure.chart, style),
                "</div>\n</figure>\n");
}

std::string NameOf(const PageContent& content, const PageScene& scene) {
  const PlannedRun& run = content.runs[scene.run].planned;
  return StrCat(KeyOf(run, "sequence"), ": ", KeyOf(run, "variant"), ", seed ", run.seed);
}

// Without the script the image in the middle of the run is seen.
std::string PlayerHtml(const PageScene& scene, const std::string& name, std::size_t index) {
  std::string html = StrCat("<div class=\"frames\" id=\"frames-", index, "\">\n",
                            Element("h3", name), "\n<figure>\n");
  for (std::size_t i = 0; i < scene.images.size(); ++i) {
    const PageImage& image = scene.images[i];
    html += StrCat("<img data-frame=\"", image.frame, "\" alt=\"", Escaped(image.alt), "\"",
                   i == scene.images.size() / 2 ? "" : " hidden", " src=\"data:image/jpeg;base64,",
                   Base64(image.jpeg), "\">\n");
  }
  return html + Element("figcaption", "Left image with what was estimated") +
         "\n</figure>\n<div class=\"player\" hidden><button type=\"button\">Play</button><input "
         "type=\"range\" min=\"0\" step=\"1\" aria-label=\"Frame\"></div>\n</div>\n";
}

std::string Origin(const PageContent& content) {
  std::string html = ListHtml("", content.origins);
  if (!content.table) return html;
  return html + Element("p", "Seeds: " + Joined(content.table->provenance.seeds, ", ")) + "\n";
}

std::string Body(const PageContent& content) {
  std::string first;  // the first player
  std::string players;
  Texts without;
  std::size_t shown = 0;
  for (const PageScene& scene : content.scenes) {
    const std::string name = NameOf(content, scene);
    if (!scene.no_images.empty()) without.push_back(StrCat(name, ": ", scene.no_images));
    if (scene.images.empty()) continue;
    ++shown;
    (shown == 1 ? first : players) += PlayerHtml(scene, name, shown);
  }
  if (shown == 0) first = ProblemHtml("No run can be shown frame by frame: see What is missing.");
  std::string forest;
  std::string figures;
  for (const Figure& figure : content.drawing.figures) {
    (figure.name == "ablation" ? forest : figures) += FigureHtml(figure);
  }
  if (content.drawing.figures.empty()) figures = ProblemHtml("No figure could be made.");
  std::string html = StrCat("<header>\n", Element("h1", content.title), "\n</header>\n<main>\n",
                            Summary(content), "<div class=\"first\">\n<section>\n");
  if (content.table) html += ShortTableHtml(*content.table);
  html += StrCat(forest, "</section>\n<section>\n", first, "</section>\n</div>\n");
  if (content.table) {
    html += Folded("table", "All values, intervals, differences and notes",
                   ResultTable(*content.table));
  }
  const std::string missing =
      StrCat(ListHtml("Runs that failed, are missing or lost the camera",
                      content.table ? ProblemTexts(*content.table) : Texts()),
             ListHtml("Missing or unreadable files", content.missing),
             ListHtml("Runs without images", without),
             ListHtml("Not shown in figures", content.drawing.not_drawn));
  return StrCat(html, Folded("figures", "More figures", figures),
                Folded("frames", "More runs frame by frame", players),
                Folded("missing", "What is missing", missing),
                Folded("origin", "Origin of the numbers", Origin(content)), "</main>\n");
}

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
  if (cell.value.empty()) return html + "></td>";
  return StrCat(html, ">", Span("value", cell.Shown()),
                cell.distinguishable ? "<abbr class=\"star\" title=\"significant\">*</abbr>" : "",
                Span("small", cell.interval), Span("small", cell.percent),
                Span("reason", cell.note), "</td>");
}

// The keys of a row are header cells; the other texts at the left are not. Figures of others stay
// with the row above them.
std::string LineHtml(const Table& table, const TextLine& line, bool differences) {
  std::string html = StrCat("<tr class=\"", line.grey ? "grey" : "",
                            line.theirs != nullptr && line.row != nullptr ? " below" : "", "\">");
  for (std::size_t i = 0; i < line.texts.size(); ++i) {
    const bool name = i < table.keys.size() && !line.texts[i].empty();
    html += Element(name ? "th" : "td", line.texts[i], name ? " scope=\"row\"" : "");
  }
  for (std::size_t i = 0; i < line.cells.size(); ++i) {
    html += CellHtml(line.cells[i], NumberOf(table, line, i, differences));
  }
  return html + "</tr>\n";
}

}  // namespace

std::string Escaped(std::string_view text) { return HtmlEscaped(Printable(text)); }

std::string ResultTable(const Table& table) {
  const TableTexts texts = MakeTexts(table);
  std::string html =
      "<p>Each value is a mean, with its 95 % interval below it. A star marks a significant "
      "difference from the reference. Grey rows are results of others; values in brackets are not "
      "comparable with ours. Select a heading to sort by it.</p>\n";
  for (std::size_t block = 0; block < texts.blocks.size(); ++block) {
    html += StrCat("<div class=\"scroll\" tabindex=\"0\">\n<table class=\"results\" id=\"table-",
                   block > 0 ? "differences" : "values", "\">\n",
                   Element("caption", texts.blocks[block].heading), "\n<thead><tr>");
    for (const std::string& name : texts.text_header) html += Element("th", name);
    for (std::size_t i = 0; i < texts.columns.size(); ++i) {
      const MetricEntry* entry = FindEntry(table.columns[i].metric);
      html +=
          StrCat("<th scope=\"col\" class=\"number\" title=\"",
                 entry ? Escaped(entry->meaning) : "", "\">", Escaped(texts.columns[i]), "</th>");
    }
    html += "</tr></thead>\n<tbody>\n";
    for (const TextLine& line : texts.blocks[block].lines) html += LineHtml(table, line, block > 0);
    html += "</tbody>\n</table>\n</div>\n";
  }
  return html + ListHtml("Notes", texts.footnotes);
}

std::string PageHtml(const PageContent& content) {
  return StrCat(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; img-src data: "
      "'self' file:; style-src 'unsafe-inline'; script-src ",
      ScriptSource(),
      "\">\n<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n",
      Element("title", content.title + ": ClusterVO-bench report"), "\n<style>", PageStyle(),
      ChartCss(), "</style>\n</head>\n<body>\n", Body(content),
      "<p id=\"script-problem\" class=\"problem\" role=\"alert\" hidden></p>\n<script>",
      PageScript(), "</script>\n</body>\n</html>\n");
}

}  // namespace cvo::reports
