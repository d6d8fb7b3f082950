// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "reports/tables/table.h"

namespace cvo::reports {

// A figure and its interval, as they are to be printed.
struct Measured {
  double value = 0.0;
  std::optional<Interval> interval;
};

// A number of events, which the results call "1" as any plain number.
inline constexpr char kCountUnit[] = "events";

// Decimals of each figure of one column. Half the width of an interval is worth two significant
// digits; its figure has at least two and at most four, and the figures of a column as many
// decimals as the one that needs most. Without an interval the unit decides.
std::vector<int> ColumnDecimals(const std::vector<Measured>& figures, const std::string& unit);

// With a fixed number of decimals; zero has no sign.
std::string Fixed(double value, int decimals);

}  // namespace cvo::reports
