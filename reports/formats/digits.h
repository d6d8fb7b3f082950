// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "reports/tables/table.h"

namespace cvo::reports {

// A figure to be printed, with its interval.
struct Measured {
  double value = 0.0;
  std::optional<Interval> interval;
};

// Unit of a number of events. Result files give it the unit "1", like any plain number.
inline constexpr char kCountUnit[] = "events";

// Returns the number of decimals of each figure of one column. Half the width of an interval is
// worth two significant digits. Its figure has at least two and at most four, and otherwise as many
// decimals as the figure of the column that needs most. Without an interval the unit decides.
std::vector<int> ColumnDecimals(const std::vector<Measured>& figures, const std::string& unit);

// Formats a value with a fixed number of decimals; zero has no sign.
std::string Fixed(double value, int decimals);

}  // namespace cvo::reports
