// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace cvo::reports {

// A figure to be drawn by Plotly. The texts are plain: whoever writes HTML must escape them. Texts
// within `plotly` are already escaped. Its layout has no title, no width, and no colours of text,
// grid and background: whoever shows the figure adds title and caption in its own style.
struct Figure {
  std::string id;       // letters, digits and "-"; used as a file name
  std::string title;    // what is shown, by which relation, delta and alignment
  std::string caption;  // how to read it: marks, intervals, machine
  std::string alt;      // what is shown and what follows from it, in words, with the main numbers
  std::string group;    // heading that the figure belongs under, such as "Error over time"
  int width_px = 0;     // on paper; the height is in the layout
  int least_px = 0;     // width below which texts overlap; 0: any width will do
  int height_px = 0;
  std::string plotly;  // JSON text {"data":[...],"layout":{...}}
};

// The figures of a suite.
struct SuiteDrawing {
  std::vector<Figure> figures;
  std::vector<std::string> not_drawn;  // what could not be drawn, and why
};

}  // namespace cvo::reports
