// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/files/json/json.h"
#include "core/files/text/number.h"
#include "reports/tables/table.h"

namespace cvo::reports {

// Rounds to significant digits, to keep pages with many points small.
inline double Rounded(double value, int digits = 4) { return RoundedTo(value, digits); }
Json RoundedList(const std::vector<double>& values, int digits = 4);

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

// The value of a cell with its interval: "0.0213 m (0.018 to 0.025)".
std::string CellValueText(const Cell& cell, const Column& column);

// Makes the first letter upper case.
std::string Capitalised(std::string text);
// Joins texts to a list: "a", "a and b", "a, b and c".
std::string Listed(const std::vector<std::string>& texts);

// Reduces a text to lower-case letters, digits and "-", for ids. At most 80 characters.
std::string Slug(const std::string& text);

// Escapes a text that Plotly draws, since Plotly interprets some HTML tags.
std::string PlotText(const std::string& text);

}  // namespace cvo::reports
