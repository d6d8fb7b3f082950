// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/figure_files/interactive_page.h"

#include "core/base/error.h"
#include "core/files/json/json.h"
#include "core/files/text/escape.h"
#include "core/files/text/utf8.h"
#include "reports/figures/plot.h"
#include "reports/web/assets.h"

namespace cvo::reports {
namespace {

constexpr char kStyle[] = R"(
:root { color-scheme: light dark; --text: #222222; --page: #ffffff; --quiet: #555555;
        --grid: #dfe2e7; --line: #5a606b; }
@media (prefers-color-scheme: dark) {
  :root { --text: #e6e8ec; --page: #15171b; --quiet: #a9afba; --grid: #343941; --line: #a9afba; }
}
body { font: 14px/1.4 'Liberation Sans', Arial, Helvetica, sans-serif; color: var(--text);
       background: var(--page); margin: 16px; }
h1 { font-size: 17px; margin: 0 0 4px; }
p { max-width: 980px; margin: 4px 0; }
details { margin-top: 16px; color: var(--quiet); }
pre { white-space: pre-wrap; }
)";

// The colours follow those of the page. If there is little room, the panels are placed one below
// the other.
constexpr char kDrawPlot[] = R"(
const plot = document.getElementById('plot');
const named = (name) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();
const template = () => {
  const axis = { gridcolor: named('--grid'), linecolor: named('--line'),
                 tickcolor: named('--line'), zerolinecolor: named('--grid') };
  return { layout: { paper_bgcolor: 'rgba(0,0,0,0)', plot_bgcolor: 'rgba(0,0,0,0)',
                     font: { color: named('--text') }, xaxis: axis, yaxis: axis } };
};
const LEAST = 640;
const GAP = 56;
const stacked = (layout) => {
  const made = structuredClone(layout);
  const { t, b, l, r } = made.margin;
  const inner = made.height - t - b;
  const rows = Object.keys(made).filter((key) => key.startsWith('yaxis'));
  const heights = rows.map((key) => {
    const [low, high] = made[key].domain ?? [0, 1];
    return Math.max(90, Math.min((high - low) * inner, 300));
  });
  const entries = figure.data.filter((trace) => trace.name && trace.showlegend !== false).length;
  made.margin = { ...made.margin, t: t + 22 * Math.max(0, entries - 1) };
  const sum = heights.reduce((total, height) => total + height + GAP, -GAP);
  let top = sum;
  rows.forEach((key, i) => {
    made[key].domain = [(top - heights[i]) / sum, top / sum];
    top -= heights[i] + GAP;
    // An axis that several panels share has its numbers below the lowest of them.
    const x = made[`xaxis${(made[key].anchor ?? 'x').slice(1)}`];
    if (x) x.anchor = `y${key.slice(5)}`;
  });
  for (const key of Object.keys(made)) {
    if (key.startsWith('xaxis')) made[key].domain = [0, 1];
  }
  made.height = made.margin.t + b + sum;
  return made;
};
const draw = () => {
  const width = Math.min(document.body.clientWidth, figure.layout.width);
  const layout = width < LEAST ? stacked(figure.layout) : figure.layout;
  Plotly.react(plot, figure.data, { ...layout, width, template: template() },
               { displaylogo: false, showSendToCloud: false });
};
draw();
window.addEventListener('resize', draw);
matchMedia('(prefers-color-scheme: dark)').addEventListener('change', draw);
)";

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
      ";", kDrawPlot, "</script></body></html>\n");
}

}  // namespace cvo::reports
