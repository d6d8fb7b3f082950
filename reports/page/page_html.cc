// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "core/files/sha256.h"
#include "core/files/text/number.h"
#include "core/files/text/utf8.h"
#include "reports/page/page.h"

namespace cvo::reports {
namespace {

constexpr std::size_t kShownJobs = 200;

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

std::string JobsWithoutValue(const std::vector<SuiteRun>& runs) {
  std::vector<std::string> lines;
  for (const char* state : {"failed", "lost", "not run", "no data"}) {
    for (const SuiteRun& run : runs) {
      if (run.state != state) continue;
      std::string line = StrCat(state, ":");
      for (const auto& [key, value] : run.planned.keys) {
        if (value != "none") line += StrCat(" ", key, " ", value, ",");
      }
      lines.push_back(StrCat(line, " seed ", run.planned.seed,
                             run.message.empty() ? "" : ": " + run.message,
                             run.log.empty() ? "" : " (log: " + run.log + ")"));
    }
  }
  if (lines.size() > kShownJobs) {
    const std::size_t more = lines.size() - kShownJobs;
    lines.resize(kShownJobs);
    lines.push_back(StrCat("and ", more, " more"));
  }
  return ListHtml("Runs that failed, are missing or lost the camera", lines);
}

std::string MissingSection(const PageContent& content) {
  std::string html = JobsWithoutValue(content.runs) +
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

}  // namespace cvo::reports
