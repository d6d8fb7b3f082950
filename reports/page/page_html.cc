// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "core/files/sha256.h"
#include "core/files/text/number.h"
#include "core/files/text/utf8.h"
#include "core/record/metric_catalogue.h"
#include "reports/figures/figure_style.h"
#include "reports/page/page.h"

namespace cvo::reports {
namespace {

constexpr std::size_t kShownJobs = 200;

// What every page explains: estimators, statistics and runs.
constexpr std::pair<const char*, const char*> kTerms[] = {
    {"variant",
     "A version of the estimator. full is the complete method; the others omit or change one "
     "part."},
    {"cluster", "A set of landmarks that move together: the estimate of one object."},
    {"landmark", "A point in the scene that is seen in the images."},
    {"sequence", "A recorded or rendered image sequence with its ground truth."},
    {"seed",
     "Initial value of the random number generator. Runs that differ only in the seed show the "
     "random variation."},
    {"interval",
     "95 % confidence interval of a mean, by bootstrap over its scenes, or the bodies of a single "
     "scene. Seeds are averaged first."},
    {"split",
     "What scenes are used for: options were chosen on development scenes, results are reported "
     "on test scenes. Recorded images are given."},
    {"pair", "A scene (or body of a single scene) that is present in both rows of a difference."},
    {"occluded, predicted",
     "Hidden by another object; its pose is then given only by the motion model."},
    {"left out", "What is excluded from a value, and why."},
};

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
      "<p>Each value is a mean, with its 95 % interval and the number of bodies or scenes below "
      "it. A star marks a significant difference from the reference. Grey rows are published "
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

std::string RunText(const SuiteRun& run) {
  std::vector<std::string> keys;
  for (const auto& [key, value] : run.planned.keys) {
    if (value != "none") keys.push_back(key + " " + value);
  }
  keys.push_back(StrCat("seed ", run.planned.seed));
  return Listed(keys);
}

std::string JobsWithoutValue(const std::vector<PageRun>& runs) {
  std::vector<std::string> lines;
  for (const char* state : {"failed", "lost", "not run", "no data"}) {
    for (const PageRun& run : runs) {
      if (run.run.state != state) continue;
      lines.push_back(StrCat(state, ": ", RunText(run.run),
                             run.run.message.empty() ? "" : ": " + run.run.message,
                             run.run.log.empty() ? "" : " (log: " + run.run.log + ")"));
    }
  }
  if (lines.size() > kShownJobs) {
    const std::size_t more = lines.size() - kShownJobs;
    lines.resize(kShownJobs);
    lines.push_back(StrCat("and ", more, " more"));
  }
  return ListHtml("Runs that failed, are missing or lost the camera", lines);
}

// Each file is listed once, with the runs that lack it.
std::string UnreadableFiles(const PageContent& content) {
  using Entry = std::pair<std::string, std::vector<std::string>>;
  std::vector<Entry> files;
  const auto add = [&files](const std::string& file, const SuiteRun& run) {
    AddOnce(RunText(run), FindOrAdd(files, &Entry::first, {file, {}}).second);
  };
  for (const PageRun& run : content.runs) {
    for (const std::string& file : run.missing) add(file, run.run);
  }
  for (const PageScene& scene : content.scenes) {
    const SuiteRun& run = content.runs[scene.run].run;
    for (const std::string& file : scene.detail.missing) add(file, run);
    if (!scene.no_images.empty()) add("images: " + scene.no_images, run);
  }
  std::vector<std::string> lines;
  for (const auto& [file, runs] : files) lines.push_back(StrCat(file, " (", Listed(runs), ")"));
  return ListHtml("Missing or unreadable files", lines);
}

std::string MissingSection(const PageContent& content) {
  std::string html = JobsWithoutValue(content.runs);
  if (content.table) html += ListHtml("Notes for comparison", content.table->notes);
  html += UnreadableFiles(content) + ListHtml("Not shown in figures", content.drawing.not_drawn);
  if (html.empty()) html = "<p>Nothing is missing.</p>\n";
  return "<section id=\"missing\">\n<h2>What is missing</h2>\n" + html + "</section>\n";
}

std::string Meaning(const Column& column) {
  const std::optional<MetricForm> form = FindForm(column.metric);
  std::string meaning = form ? EntryOf(form->id).meaning : "See its definition below the table.";
  if (form && form->bodies == BodyGroup::kStanding) meaning += " Of objects that stand still.";
  if (form && form->bodies == BodyGroup::kPredicted) {
    meaning += " Of frames in which it was predicted.";
  }
  if (form && form->causal) meaning += " Causal: of the estimates at the time of each frame.";
  if (const MetricEntry* entry = FindEntry(column.metric)) {
    meaning += entry->higher_is_better() ? " Higher is better." : " Lower is better.";
  }
  return meaning;
}

std::string GlossarySection(const PageContent& content) {
  std::string html = "<section id=\"glossary\">\n<h2>Terms and metrics</h2>\n<dl>\n";
  for (const auto& [name, meaning] : kTerms) {
    html += Element("dt", name) + Element("dd", meaning) + "\n";
  }
  if (content.table) {
    for (const Column& column : content.table->columns) {
      html += Element("dt", column.label) + Element("dd", Meaning(column)) + "\n";
    }
  }
  return html + "</dl>\n</section>\n";
}

// Lists each distinct set of facts once, with the number of runs it applies to.
std::string FactsWithRunCounts(const std::vector<PageRun>& runs, std::vector<Fact> PageRun::*facts,
                               const char* heading) {
  using Count = std::pair<std::vector<Fact>, std::size_t>;
  std::vector<Count> counted;
  for (const PageRun& run : runs) {
    if (!(run.*facts).empty()) ++FindOrAdd(counted, &Count::first, {run.*facts, 0}).second;
  }
  std::string html = Element("h3", heading) + "\n";
  if (counted.empty()) html += "<p>Not known.</p>\n";
  for (const auto& [of_runs, count] : counted) {
    html += Element("p", Counted(count, "run") + ":") + "\n" + FactsHtml(of_runs);
  }
  return html;
}

std::string OptionsHtml(const Provenance& provenance) {
  std::string html = "<h3>Options with values other than the default</h3>\n";
  if (provenance.options.empty()) return html + "<p>None.</p>\n";
  html += "<ul>\n";
  for (const ChangedOption& option : provenance.options) {
    const std::string usual = option.default_value;
    html += StrCat("<li>", Element("code", option.path), ": ", Escaped(Listed(option.values)),
                   usual.empty() ? "" : StrCat(" (default ", Escaped(usual), ")"), "</li>\n");
  }
  return html + "</ul>\n";
}

std::string OriginSection(const PageContent& content) {
  std::string html = "<section id=\"origin\">\n<h2>Origin of the numbers</h2>\n";
  html += FactsWithRunCounts(content.runs, &PageRun::build, "Program") +
          FactsWithRunCounts(content.runs, &PageRun::machine, "Machine");
  if (content.table) {
    const Provenance& provenance = content.table->provenance;
    html += OptionsHtml(provenance) + "<h3>Seeds</h3>\n" +
            Element("p", Joined(provenance.seeds, ", ")) + "\n";
  }
  return html + "</section>\n";
}

std::string Navigation(const PageContent& content) {
  std::vector<Fact> parts = {{"summary", "Summary"}, {"table", "Table"}};
  if (!content.compared_with.empty()) {
    parts.emplace_back("comparison", "Compared with " + content.compared_with);
  }
  parts.insert(parts.end(), {{"figures", "Figures"},
                             {"frames", "Frame by frame"},
                             {"missing", "What is missing"},
                             {"glossary", "Terms and metrics"},
                             {"origin", "Origin of the numbers"}});
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
             Navigation(content), "</header>\n<main>\n", SummarySection(content),
             TableSection(content), ComparisonSection(content), FiguresSection(content),
             FramesSection(content), MissingSection(content), GlossarySection(content),
             OriginSection(content), "</main>\n"));
}

}  // namespace cvo::reports
