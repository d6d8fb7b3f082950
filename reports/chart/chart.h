// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace cvo::reports {

// A chart as plain data, and the function that writes it as SVG. Texts are plain; they are escaped
// when they are written. A coordinate that is not finite is a gap.

enum class Symbol { kNone, kCircle, kSquare, kDiamond, kTriangle };

// How a mark looks.
struct Look {
  int colour = 1;  // 1 to kChartColours of the palette; 0: the grey of truth and references
  Symbol symbol = Symbol::kNone;
  int dash = 0;          // 0: solid; 1: dashes; 2: dash and dot; 3: long dashes; 4: dots
  double width = 1.0;    // of lines (pt)
  double opacity = 1.0;  // of fills
};

inline constexpr int kChartColours = 8;

struct ValueRange {
  double low = 0.0;
  double high = 0.0;
};

// A value of a series. On a category axis, category i is at coordinate i.
struct Datum {
  double x = 0.0;
  double y = 0.0;
  std::string tip = {};                       // tooltip of this value; empty: that of its series
  std::string text = {};                      // drawn beside a point, above it if there is room
  bool text_below = false;                    // below it if there is room
  std::optional<ValueRange> y_interval = {};  // the height of a band
};

enum class SeriesKind {
  kLine,   // through the data, with the symbol of its look at each of them
  kBand,   // area between the ends of the y intervals
  kPoints  // symbols
};

struct Series {
  SeriesKind kind = SeriesKind::kLine;
  std::string name;  // in the legend, once per chart; empty: not in the legend
  Look look;
  std::vector<Datum> data;
  std::string tip = {};  // tooltip of the whole series; empty: its name
};

// A region behind the data from the bottom of the panel to its top.
using Shade = ValueRange;

enum class AxisScale { kLinear, kLog, kCategory };

struct Axis {
  std::string title;
  AxisScale scale = AxisScale::kLinear;
  std::vector<std::string> categories = {};  // kCategory, on y only: from top to bottom
  std::vector<double> ticks = {};            // empty: chosen for the range
  std::optional<double> low = {};            // end of the range; empty: from the data
  std::optional<double> high = {};
  bool from_zero = false;  // the range begins at 0 if there is nothing below
};

// One system of axes.
struct Panel {
  std::string title;  // above its left corner
  Axis x;
  Axis y;
  std::vector<Series> series = {};  // later ones cover earlier ones
  std::vector<Shade> shades = {};
  std::optional<double> rule = {};  // a dotted line from top to bottom at this x
  std::string rule_text = {};       // above it
  double aspect = 0.25;             // height / width; not of a panel with categories on y
  bool equal_scale = false;         // one unit is as long on y as on x; `aspect` is then a limit
};

struct Chart {
  std::string title;    // drawn above in bold if not empty, the first sentence alone
  std::string caption;  // drawn below if not empty
  std::vector<Panel> panels;
  int columns = 1;       // at most; panels are laid out row by row
  bool share_x = false;  // panels with the same x title have the same range, labelled once a column
  bool share_y = false;  // the same for y, labelled in the first column
  double width = 1.0;    // as a part of ChartStyle::width_mm
};

struct ChartStyle {
  double width_mm = 170.0;
  std::string font = "Liberation Sans, Arial, Helvetica, sans-serif";
  double font_size_pt = 8.0;
  bool texts = true;  // whether files of figures have their title and caption
  bool css = true;    // false: the page has ChartCss in its own style
};

// An <svg> element, alone a file that is right on white paper. It has no ids, and its classes begin
// with "chart". Colours follow these CSS variables where a page sets them, on the page or a parent:
// --chart-ink, --chart-grid, --chart-paper, --chart-truth, --chart-1 to --chart-8. The same chart
// and style give the same bytes.
std::string ChartSvg(const Chart& chart, const ChartStyle& style = {});

// The rules of the classes, for a page with several charts.
std::string ChartCss();

}  // namespace cvo::reports
