// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "reports/tables/table.h"

namespace cvo::reports {

// A number with its unit for readers: "0.0625 m", "93.1 %" for a share, "3" for a count.
std::string QuantityText(double value, const Column& column);
// The same for a difference, with its sign.
std::string ChangeText(double value, const Column& column);
// An interval with its unit: "0.05 to 0.07 m".
std::string RangeText(const Interval& interval, const Column& column);

// "lower" or "higher", whichever is better; empty if the metric is unknown.
std::string BetterDirection(const std::string& metric);

}  // namespace cvo::reports
