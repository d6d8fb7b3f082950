// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/page/quantity.h"

#include <array>
#include <cmath>
#include <cstdio>

#include "core/base/error.h"
#include "reports/tables/metric_rule.h"

namespace cvo::reports {
namespace {

std::string Printed(const char* format, double value) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), format, value);
  return text.data();
}

// Three digits that count, and no exponent for what people compare by eye.
std::string Number(double value) {
  const double size = std::abs(value);
  if (size == 0.0) return "0";
  if (size >= 1e6 || size < 1e-6) return Printed("%.2e", value);
  int decimals = 2 - static_cast<int>(std::floor(std::log10(size)));
  if (decimals < 0) decimals = 0;
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%.*f", decimals, value);
  return text.data();
}

// Fractions are told in percent.
double Shown(double value, const std::string& unit) { return unit == "1" ? 100.0 * value : value; }

std::string ShownUnit(const std::string& unit) { return unit == "1" ? "%" : unit; }

}  // namespace

std::string QuantityText(double value, const std::string& unit) {
  const std::string name = ShownUnit(unit);
  return Number(Shown(value, unit)) + (name.empty() ? "" : " " + name);
}

std::string ChangeText(double value, const std::string& unit) {
  const std::string what = unit == "1" ? "percentage points" : unit;
  return StrCat(value > 0.0 ? "+" : "", Number(Shown(value, unit)), what.empty() ? "" : " ", what);
}

std::string RangeText(const Interval& interval, const std::string& unit) {
  return StrCat(Number(Shown(interval.low, unit)), " to ", QuantityText(interval.high, unit));
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
