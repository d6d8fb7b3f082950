// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/figure_files/interactive_page.h"

#include "core/base/error.h"
#include "core/files/escape.h"
#include "core/files/json.h"
#include "core/files/utf8.h"
#include "reports/figures/plot.h"
#include "reports/web/assets.h"

namespace cvo::reports {
namespace {

constexpr char kStyle[] =
    "body{font:14px/1.4 'Liberation Sans',Arial,Helvetica,sans-serif;color:#222;background:#fff;"
    "margin:16px}h1{font-size:17px;margin:0 0 4px}p{max-width:980px;margin:4px 0}"
    "#plot{overflow-x:auto}details{margin-top:16px;color:#555}pre{white-space:pre-wrap}";

std::string EscapedText(std::string_view text) { return HtmlEscaped(Printable(text)); }

}  // namespace

std::string InteractivePage(const Figure& figure) {
  Json plotly = ParseJson(figure.plotly, "figure " + figure.id);
  plotly["layout"]["width"] = figure.width_px;
  const std::size_t end = figure.title.find(". ");
  const std::string how = end == std::string::npos ? "" : figure.title.substr(end + 2) + ". ";
  return StrCat(
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>",
      EscapedText(figure.title), "</title>\n<style>", kStyle, "</style>\n<script>", PlotlyScript(),
      "</script></head>\n<body><h1>", EscapedText(figure.title.substr(0, end)), "</h1>\n<p>",
      EscapedText(how), EscapedText(figure.caption),
      "</p>\n<div id=\"plot\" role=\"img\" aria-label=\"", EscapedText(figure.alt),
      "\"></div>\n<details><summary>Licence of Plotly</summary><pre>", HtmlEscaped(PlotlyLicence()),
      "</pre></details>\n<script>\nconst figure = ", PlotJson(plotly["data"], plotly["layout"]),
      ";\nPlotly.newPlot('plot', figure.data, figure.layout, {displaylogo: false});\n"
      "</script></body></html>\n");
}

}  // namespace cvo::reports
