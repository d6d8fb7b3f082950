// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/formats/digits.h"

#include <algorithm>
#include <cmath>

#include "core/files/text/number.h"

namespace cvo::reports {
namespace {

constexpr int kMaxDecimals = 9;
// Relative to the figure: a narrower interval is one of equal values up to rounding.
constexpr double kNoWidth = 1e-9;

// Returns the number of decimals that shows the given significant digits of a nonzero value.
int Significant(double value, int digits) {
  return std::clamp(digits - 1 - static_cast<int>(std::floor(std::log10(std::abs(value)))), 0,
                    kMaxDecimals);
}

int ByUnit(double value, const std::string& unit) {
  if (unit == kCountUnit) return value == std::floor(value) ? 0 : 2;
  if (unit == "m" || unit == "rad") return std::abs(value) < 0.01 && value != 0.0 ? 5 : 4;
  if (unit == "%") return 2;
  if (unit == "1" || value == 0.0) return 3;
  return Significant(value, 4);
}

// Returns the magnitude that determines the number of digits: that of the value or, if it is 0, of
// its interval.
double Magnitude(const Measured& figure) {
  if (figure.value != 0.0 || !figure.interval) return figure.value;
  return std::max(std::abs(figure.interval->low), std::abs(figure.interval->high));
}

// Returns the decimals that follow from the interval; empty if it does not determine them.
std::optional<int> ByInterval(const Measured& figure) {
  if (!figure.interval) return std::nullopt;
  const double half = 0.5 * (figure.interval->high - figure.interval->low);
  const double magnitude = Magnitude(figure);
  if (!(half > kNoWidth * std::abs(magnitude)) || !std::isfinite(half)) return std::nullopt;
  if (magnitude == 0.0) return Significant(half, 2);
  return std::clamp(Significant(half, 2), Significant(magnitude, 2), Significant(magnitude, 4));
}

}  // namespace

std::vector<int> ColumnDecimals(const std::vector<Measured>& figures, const std::string& unit) {
  std::optional<int> most;
  for (const Measured& figure : figures) {
    if (const std::optional<int> own = ByInterval(figure)) most = std::max(most.value_or(0), *own);
  }
  std::vector<int> decimals;
  for (const Measured& figure : figures) {
    const bool alone = !figure.interval || !most;
    const double magnitude = Magnitude(figure);
    const int limit = magnitude == 0.0 ? kMaxDecimals : Significant(magnitude, 4);
    decimals.push_back(alone ? ByUnit(figure.value, unit)
                             : std::max(ByInterval(figure).value_or(0), std::min(*most, limit)));
  }
  return decimals;
}

std::string Fixed(double value, int decimals) {
  std::string fixed = FormatFixed(value, decimals);
  if (fixed[0] == '-' && fixed.find_first_not_of("-0.") == std::string::npos) fixed.erase(0, 1);
  return fixed;
}

}  // namespace cvo::reports
