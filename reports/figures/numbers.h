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

// Rounded to significant digits, to keep pages with many points small.
inline double Rounded(double value, int digits = 4) { return RoundedTo(value, digits); }
Json RoundedList(const std::vector<double>& values, int digits = 4);

// For sentences: three significant digits, without exponents.
std::string NumberText(double value, int digits = 3);

// How figures show a metric: shares in percent, the rest in its own unit.
struct Shown {
  double scale = 1.0;
  std::string unit;  // empty: a count
  bool higher_is_better = false;
  bool is_share = false;
  bool is_error = false;
};
Shown ShownAs(const std::string& metric, const std::string& unit);

// "object ATE", its contract in words where it has any: "object ATE (m)".
std::string AxisTitle(const Column& column);

// "0.0213 m (0.018 to 0.025)".
std::string CellValueText(const Cell& cell, const Column& column);

// First letter large.
std::string Capitalised(std::string text);
// "a", "a and b", "a, b and c".
std::string Listed(const std::vector<std::string>& texts);

// Letters, digits and "-", for ids.
std::string Slug(const std::string& text);

// For texts that Plotly draws, which reads some tags of HTML in them.
std::string PlotText(const std::string& text);

}  // namespace cvo::reports
