// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/page/quantity.h"

#include "core/base/error.h"
#include "reports/figures/numbers.h"
#include "reports/tables/metric_rule.h"

namespace cvo::reports {
namespace {

// Fractions are told in percent.
double Scaled(double value, const std::string& unit) { return unit == "1" ? 100.0 * value : value; }

std::string ShownUnit(const std::string& unit) { return unit == "1" ? "%" : unit; }

}  // namespace

std::string QuantityText(double value, const std::string& unit) {
  const std::string name = ShownUnit(unit);
  return Say(Scaled(value, unit)) + (name.empty() ? "" : " " + name);
}

std::string ChangeText(double value, const std::string& unit) {
  const std::string what = unit == "1" ? "percentage points" : unit;
  return StrCat(value > 0.0 ? "+" : "", Say(Scaled(value, unit)), what.empty() ? "" : " ", what);
}

std::string RangeText(const Interval& interval, const std::string& unit) {
  return StrCat(Say(Scaled(interval.low, unit)), " to ", QuantityText(interval.high, unit));
}

std::string BetterDirection(const std::string& metric) {
  const auto rule = FindRule(metric);
  return !rule ? "" : rule->higher_is_better ? "higher" : "lower";
}

std::optional<bool> IsBetter(const std::string& metric, double difference) {
  const auto rule = FindRule(metric);
  if (!rule) return std::nullopt;
  return (difference > 0.0) == rule->higher_is_better;
}

}  // namespace cvo::reports
