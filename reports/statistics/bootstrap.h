// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <vector>

#include "reports/statistics/strata.h"

namespace cvo::reports {

inline constexpr int kResamples = 5000;
inline constexpr double kConfidence = 0.95;

struct Range {
  double low = 0.0;
  double high = 0.0;

  bool Contains(double value) const { return low <= value && value <= high; }
};

// Value and reference of resampled strata, always the same ones for the same numbers of units.
// Of n units n - 1 are drawn with replacement (McCarthy and Snowden 1985): drawing n makes the
// interval of a mean too narrow by sqrt((n - 1) / n). A stratum of one unit stays as it is. Empty
// where no stratum has two units.
std::vector<std::array<double, 2>> Bootstrap(const std::vector<std::vector<Unit>>& strata,
                                             Within within);

// What lies in the middle kConfidence of the values. Empty where there are none.
std::optional<Range> MiddleRange(std::vector<double> values);

}  // namespace cvo::reports
