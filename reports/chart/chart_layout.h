// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "reports/chart/chart.h"

namespace cvo::reports {

// Where everything of a chart is drawn. All lengths are in points, from the upper left corner; em
// is the font size.

inline constexpr double kLineHeight = 1.3;  // distance of lines of text (em)

struct Tick {
  double value = 0.0;
  std::string label;
};

// The range of an axis (logarithms for kLog), and the lengths between which it is drawn.
struct Scale {
  AxisScale kind = AxisScale::kLinear;
  ValueRange range;
  ValueRange place;
  std::vector<Tick> ticks;

  // Not finite for a value without a place.
  double Of(double value) const;
};

struct PanelPlace {
  double left = 0.0;
  double top = 0.0;
  double width = 0.0;
  double height = 0.0;
  Scale x;
  Scale y;
  bool labels_x = true;
  bool labels_y = true;
};

struct ChartText {
  double x = 0.0;
  double y = 0.0;  // of the baseline
  std::string text;
  bool bold = false;
};

struct LegendEntry {
  double x = 0.0;
  double y = 0.0;  // of its middle
  const Series* series = nullptr;
};

struct ChartLayout {
  double width = 0.0;
  double height = 0.0;
  double em = 0.0;
  std::vector<ChartText> texts;  // title and caption
  std::vector<LegendEntry> legend;
  std::vector<PanelPlace> panels;  // in the order of the chart
};

// `chart` must outlive the result.
ChartLayout LayOut(const Chart& chart, const ChartStyle& style);

// Estimates of a wide sans serif font, since the fonts of the reader are not known.
double TextWidth(const std::string& text, double em);
std::vector<std::string> WrapText(const std::string& text, double width, double em);
// The length of a line sample in the legend (em).
inline constexpr double kSample = 2.0;

}  // namespace cvo::reports
