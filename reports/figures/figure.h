// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace cvo::reports {

// A figure as Plotly draws it. Texts are plain: who writes HTML escapes them. Texts within `plotly`
// are escaped already, and its layout has neither title nor width nor colours of text, grid and
// background: whoever shows the figure puts title and caption around it in its own.
struct Figure {
  std::string id;       // letters, digits and "-": a file's name
  std::string title;    // what, by which relation, delta and alignment
  std::string caption;  // how to read it: marks, intervals, machine
  std::string alt;      // text alternative: what is shown and what it says, with its main numbers
  std::string group;    // heading that it belongs to, such as "Error over time"
  int width_px = 0;     // on paper; the height is in the layout
  int least_px = 0;     // width below which texts cover each other; 0: any will do
  int height_px = 0;
  std::string plotly;  // JSON text {"data":[...],"layout":{...}}
};

// What is drawn of a suite.
struct SuiteDrawing {
  std::vector<Figure> figures;
  std::vector<std::string> not_drawn;  // what could not be drawn, and why
};

}  // namespace cvo::reports
