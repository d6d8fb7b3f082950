// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "reports/figure_files/paper_figure.h"

namespace cvo::reports {

// A page that draws the figures with Plotly and leaves them as SVG in its own text; nothing in it
// is random. No network.
std::string RenderPage(const std::vector<PaperFigure>& figures);

// The SVG texts, in order and with their captions, from the text of that page once it has run.
// Throws Error with what the page says where it failed.
std::vector<std::string> ReadRendered(std::string_view dumped_page,
                                      const std::vector<PaperFigure>& figures);

// A page of the size of one figure, to be printed.
std::string PrintPage(const std::string& svg, const PaperFigure& figure);

// A PDF without when it was made: dates become one fixed day of the same length, identifiers zeros.
std::string WithoutDates(std::string pdf);

}  // namespace cvo::reports
