// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/page/page_html.h"

#include <string_view>

#include "core/base/error.h"
#include "core/files/json/json.h"
#include "reports/figures/plot.h"
#include "reports/page/html.h"
#include "reports/page/page_parts.h"
#include "reports/web/assets.h"

namespace cvo::reports {
namespace {

std::string Head(const PageContent& content) {
  return StrCat(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"",
      Escaped(ContentPolicy()),
      "\">\n<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<meta name=\"color-scheme\" content=\"light dark\">\n<title>",
      Escaped(content.title), ": ClusterVO-bench report</title>\n<style>", AppStyle(),
      "</style>\n</head>\n");
}

std::string Navigation(const PageContent& content) {
  std::string html = "<nav aria-label=\"Parts of this page\"><ul>\n";
  const auto add = [&html](const char* id, const std::string& name) {
    html += StrCat("<li><a href=\"#", id, "\">", name, "</a></li>\n");
  };
  add("summary", "Summary");
  add("table", "Table");
  if (!content.compared_with.empty()) {
    add("comparison", Escaped("Compared with " + content.compared_with));
  }
  add("figures", "Figures");
  add("scenes", "Frame by frame");
  add("missing", "What is missing");
  add("glossary", "Terms and metrics");
  add("origin", "Origin of the numbers");
  return html + "</ul></nav>\n";
}

std::string Body(const PageContent& content) {
  return StrCat("<body>\n<a class=\"skip\" href=\"#summary\">Skip to the summary</a>\n<header>\n",
                Element("h1", content.title), "\n<p>Results of ClusterVO-bench</p>\n",
                Navigation(content), "</header>\n<main>\n", SummarySection(content),
                TableSection(content), ComparisonSection(content), FigureSection(content),
                SceneSection(content), MissingSection(content), GlossarySection(content),
                OriginSection(content), "</main>\n<footer>\n", LicenceSection(), "</footer>\n");
}

std::string Script(std::string_view text) { return StrCat("<script>", text, "</script>\n"); }

// The JSON of a figure. A figure that is not valid JSON becomes an empty one.
std::string FigureJson(const Figure& figure) {
  try {
    return ScriptJson(ParseJson(figure.plotly, figure.id));
  } catch (const Error&) {
    return "{}";
  }
}

}  // namespace

// The script of the page comes before the large parts, so that the page can be used at once.
std::string PageHtml(const PageContent& content) {
  std::string html = Head(content) + Body(content);
  html += DataBlock("page-data", PageDataJson(content));
  html += Script(AppScript());
  for (std::size_t i = 0; i < content.drawing.figures.size(); ++i) {
    html += DataBlock(StrCat("figure-", i), FigureJson(content.drawing.figures[i]));
  }
  html += Script(PlotlyScript());
  for (std::size_t i = 0; i < content.scenes.size(); ++i) {
    html += DataBlock(StrCat("scene-", i), ScriptJson(SceneJson(content.scenes[i])));
  }
  return html + "</body>\n</html>\n";
}

}  // namespace cvo::reports
