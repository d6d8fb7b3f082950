// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/page/quantity.h"

#include "core/base/error.h"
#include "reports/figures/numbers.h"
#include "reports/results/metric_catalogue.h"

namespace cvo::reports {
namespace {

std::string WithUnit(const std::string& number, const std::string& unit) {
  return unit.empty() ? number : StrCat(number, " ", unit);
}

}  // namespace

std::string QuantityText(double value, const Column& column) {
  const Shown shown = ShownAs(column.metric, column.unit);
  return WithUnit(NumberText(shown.scale * value), shown.unit);
}

std::string ChangeText(double value, const Column& column) {
  const Shown shown = ShownAs(column.metric, column.unit);
  return WithUnit(StrCat(value > 0.0 ? "+" : "", NumberText(shown.scale * value)),
                  shown.is_share ? "percentage points" : shown.unit);
}

std::string RangeText(const Interval& interval, const Column& column) {
  const Shown shown = ShownAs(column.metric, column.unit);
  return StrCat(NumberText(shown.scale * interval.low), " to ",
                QuantityText(interval.high, column));
}

std::string BetterDirection(const std::string& metric) {
  const MetricEntry* rule = FindEntry(metric);
  return !rule ? "" : rule->higher_is_better() ? "higher" : "lower";
}

}  // namespace cvo::reports
