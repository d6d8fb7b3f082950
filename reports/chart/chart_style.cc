// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// The colours of charts.
#include <array>

#include "core/base/error.h"
#include "core/files/text/number.h"
#include "reports/chart/chart_layout.h"

namespace cvo::reports {
namespace {

// The grey of the truth, then the colours of Okabe and Ito, which colour-blind people can tell
// apart, and two more.
constexpr std::array kColours = {"#8a8a8a", "#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                 "#e69f00", "#56b4e9", "#a0892c", "#7a5195"};
constexpr std::array kDashes = {"", "5 3", "5 2 1 2", "9 3", "1 2.5"};  // in line widths

}  // namespace

std::string Num(double value) {
  std::string text = FormatFixed(value, 2);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text == "-0" ? "0" : text;
}

std::string Fill(int colour, double opacity) {
  return StrCat(" class=\"chart-f", colour, "\" fill=\"",
                kColours.at(static_cast<std::size_t>(colour)), "\"",
                opacity < 1.0 ? StrCat(" fill-opacity=\"", Num(opacity), "\"") : "");
}

std::string Stroke(const Look& look, double width) {
  std::string text = StrCat(" class=\"chart-s", look.colour, "\" fill=\"none\" stroke=\"",
                            kColours.at(static_cast<std::size_t>(look.colour)),
                            "\" stroke-width=\"", Num(width), "\"");
  if (look.opacity < 1.0) text += StrCat(" stroke-opacity=\"", Num(look.opacity), "\"");
  if (look.dash > 0) {
    text += StrCat(" stroke-dasharray=\"", kDashes.at(static_cast<std::size_t>(look.dash)), "\"");
  }
  return text;
}

std::string ChartCss() {
  std::string css =
      "svg.chart{fill:var(--chart-ink,#222222);background:var(--chart-paper,#ffffff)}"
      ".chart-axis{stroke:var(--chart-ink,#222222)}.chart-grid{stroke:var(--chart-grid,#dddddd)}"
      ".chart-shade{fill:var(--chart-grid,#dddddd)}";
  for (std::size_t i = 0; i < kColours.size(); ++i) {
    const std::string value =
        StrCat("var(--chart-", i == 0 ? "truth" : StrCat(i), ",", kColours[i], ")}");
    css += StrCat(".chart-s", i, "{stroke:", value, ".chart-f", i, "{fill:", value);
  }
  return css;
}

}  // namespace cvo::reports
