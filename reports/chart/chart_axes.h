// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "reports/chart/chart.h"

namespace cvo::reports {

// Ranges, ticks and places of axes, and the sizes of texts. Lengths are in points, from the upper
// left corner; em is the font size.

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

struct Box {
  double left, top, right, bottom;
};

// Where a panel is drawn.
struct Place {
  Scale x;
  Scale y;
  // Whether the axes have their labels and titles: of panels that share one, the lowest of a column
  // and the first of a row.
  bool labels_x = true;
  bool labels_y = true;
  double widest_y = 0.0;  // label of a tick
  double left = 0.0;
  double width = 0.0;
  double height = 0.0;
  Box box{};  // of the panel, once its row is drawn
};

// Everything about the panels but their tops. All have the same width.
std::vector<Place> PlacePanels(const Chart& chart, std::size_t columns, double width, double em);

inline constexpr double kLineHeight = 1.3;  // distance of lines of text (em)

// Estimates of a wide sans serif font, since the fonts of the reader are not known.
double TextWidth(const std::string& text, double em);
// Breaks at blanks, and after "_" in a word wider than `width`.
std::vector<std::string> WrapText(const std::string& text, double width, double em);

}  // namespace cvo::reports
