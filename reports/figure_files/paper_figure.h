// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "reports/figures/figure.h"

namespace cvo::reports {

// A figure that stands alone, black on white, its title above and its caption below it.
struct PaperFigure {
  std::string plotly;     // JSON text {"data":[...],"layout":{...}}, with room for the texts
  std::string texts_svg;  // title and caption, to go before the end of the SVG that Plotly makes
  std::string title;      // plain
  int width_px = 0;
  int height_px = 0;
};
PaperFigure ToPaperFigure(const Figure& figure);

// All there is of a figure, as JSON for other programs.
std::string FigureJson(const Figure& figure);

// Breaks a text into lines of limited length; a longer word gets its own line.
std::vector<std::string> Wrapped(const std::string& text, std::size_t characters);

}  // namespace cvo::reports
