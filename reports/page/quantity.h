// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "reports/tables/table.h"

namespace cvo::reports {

// A number with its unit as a reader sees it: "0.0625 m", "93.1 %" of a share, "3" of a count.
std::string QuantityText(double value, const Column& column);
// With its sign.
std::string ChangeText(double value, const Column& column);
// "0.05 to 0.07 m".
std::string RangeText(const Interval& interval, const Column& column);

// "lower", "higher", or empty if neither is defined as better.
std::string BetterDirection(const std::string& metric);

}  // namespace cvo::reports
