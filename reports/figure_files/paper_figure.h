// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "reports/figures/figure.h"

namespace cvo::reports {

// A stand-alone figure, black on white, with its title above and its caption below it.
struct PaperFigure {
  std::string plotly;     // JSON text {"data":[...],"layout":{...}}, with room for the texts
  std::string texts_svg;  // title and caption, to be inserted at the end of the SVG from Plotly
  std::string title;      // plain text
  int width_px = 0;
  int height_px = 0;
};
PaperFigure ToPaperFigure(const Figure& figure);

// Everything in a figure, as JSON for other programs.
std::string FigureJson(const Figure& figure);

// Breaks a text into lines of limited length; a longer word gets its own line.
std::vector<std::string> Wrapped(const std::string& text, std::size_t characters);

}  // namespace cvo::reports
