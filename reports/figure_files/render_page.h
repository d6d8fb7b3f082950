// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "reports/figure_files/paper_figure.h"

namespace cvo::reports {

// A page that draws the figures with Plotly and leaves them as SVG in its own text. It is
// deterministic and needs no network.
std::string RenderPage(const std::vector<PaperFigure>& figures);

// Extracts the SVG texts, in order and with titles and captions inserted, from the dumped text of
// that page after its script has run. Throws Error with the message of the page if it failed.
std::vector<std::string> ReadRendered(std::string_view dumped_page,
                                      const std::vector<PaperFigure>& figures);

// A page of the size of one figure, for printing.
std::string PrintPage(const std::string& svg, const PaperFigure& figure);

// Removes from a PDF what depends on the time of its creation: dates become one fixed day of the
// same length, identifiers become zeros.
std::string WithoutDates(std::string pdf);

}  // namespace cvo::reports
