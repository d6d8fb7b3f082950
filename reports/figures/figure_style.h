// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "reports/chart/chart.h"
#include "reports/tables/table.h"

namespace cvo::reports {

// Numbers, texts and looks, the same in all figures and pages.

// A number for sentences: `digits` significant digits, no exponent.
std::string NumberText(double value, int digits = 3);

// How figures show a metric: shares in percent, everything else in its own unit.
struct Shown {
  double scale = 1.0;
  std::string unit;  // empty: a count
  bool higher_is_better = false;
  bool is_share = false;
  bool is_error = false;
};
Shown ShownAs(const std::string& metric, const std::string& unit);

// The label of a metric with its unit: "object ATE (m)".
std::string AxisTitle(const Column& column);

// The label of a column, with its unit if another column has the same label.
std::string NameOf(const Column& column, const Table& table);

// A number with its unit for readers: "0.0625 m", "93.1 %" for a share, "3" for a count.
std::string QuantityText(double value, const Column& column);

// The value of a cell with its interval: "0.0213 m (0.018 to 0.025)".
std::string CellValueText(const Cell& cell, const Column& column);

// Describes for a title how metrics are measured. Metrics that are measured alike are listed
// together: "object ATE: aligned in the world frame by the camera; camera T.RPE: delta all, not
// aligned". Empty for shares and counts.
std::string RelationText(const std::vector<const Column*>& columns);

// Describes the intervals of these columns, each wording once.
std::string IntervalText(const Table& table, const std::vector<std::size_t>& columns);

// Makes the first letter upper case.
std::string Capitalised(std::string text);

// Reduces a text to lower-case letters, digits and "-", for file names. At most 80 characters.
std::string Slug(const std::string& text);

// Gives each name a look of its own, in the order given: colour and symbol, and dashes once the
// colours repeat.
class Palette {
 public:
  explicit Palette(const std::vector<std::string>& names);

  // Look without a symbol, for lines, and with one, for points.
  Look Line(const std::string& name, double width = 1.2) const;
  Look Points(const std::string& name) const;

 private:
  std::vector<std::string> names_;
};

}  // namespace cvo::reports
