// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/figures/figure_style.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <numbers>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "core/files/text/number.h"
#include "core/record/contract.h"
#include "core/record/metric_catalogue.h"

namespace cvo::reports {
std::string NumberText(double value, int digits) {
  if (value == 0.0 || !std::isfinite(value)) return value == 0.0 ? "0" : "no number";
  const int magnitude =
      static_cast<int>(std::floor(std::log10(std::abs(RoundedTo(value, digits)))));
  const int decimals = std::clamp(digits - 1 - magnitude, 0, 12);
  std::string text = FormatFixed(RoundedTo(value, digits), decimals);
  if (text.find('.') == std::string::npos) return text;
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text;
}

std::string Shown::Text(double value) const {
  return StrCat(NumberText(scale * value), unit.empty() ? "" : " ", unit);
}

Shown ShownAs(const Column& column, double largest) {
  const MetricEntry* rule = FindEntry(column.metric);
  if (rule && rule->kind == MetricKind::kFraction && column.unit == "1") return {100.0, "%", true};
  if (column.unit == "m" && largest > 0.0 && largest < 0.01) return {1e3, "mm"};
  if (column.unit == "m" && largest > 0.0 && largest < 0.5) return {1e2, "cm"};
  if (column.unit == "rad") return {180.0 / std::numbers::pi, "deg"};
  return {1.0, column.unit == "1" ? "" : column.unit};
}

std::string AxisTitle(const Column& column, const Shown& shown) {
  return StrCat(column.label, " (", shown.unit.empty() ? "count" : shown.unit, ")");
}

bool IsDrawn(const Table& table, const Row& row, std::size_t column) {
  const std::string& metric = table.columns[column].metric;
  const MetricEntry* rule = FindEntry(metric);
  const Column* coverage = FindBy(table.columns, &Column::metric, CoverageOf(metric));
  if (!row.cells[column].value) return false;
  if (!rule || rule->kind != MetricKind::kCount || coverage == nullptr) return true;
  return row.cells[static_cast<std::size_t>(coverage - table.columns.data())].value != 0.0;
}

std::string Capitalised(std::string text) {
  if (!text.empty()) {
    text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  }
  return text;
}

std::string Slug(const std::string& text) {
  std::string slug;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 128 && std::isalnum(byte) != 0) {
      slug += static_cast<char>(std::tolower(byte));
    } else if (!slug.empty() && slug.back() != '-') {
      slug += '-';
    }
  }
  while (!slug.empty() && slug.back() == '-') slug.pop_back();
  if (slug.empty()) slug.push_back('x');
  constexpr std::size_t kLongest = 80;
  if (slug.size() > kLongest) slug.resize(kLongest);
  return slug;
}

std::string RelationText(const std::vector<const Column*>& columns) {
  using Group = std::pair<std::string, std::vector<std::string>>;  // relation, labels
  std::vector<Group> groups;
  for (const Column* column : columns) {
    const MetricEntry* rule = FindEntry(column->metric);
    if (!rule || rule->kind != MetricKind::kError) continue;
    const std::string relation = RelationText(column->contract);
    AddOnce(column->label, FindOrAdd(groups, &Group::first, {relation, {}}).second);
  }
  return Joined(groups, "; ", [](const Group& group) {
    return StrCat(Joined(group.second, ", "), ": ", group.first);
  });
}

Palette::Palette(const std::vector<std::string>& names) {
  for (const std::string& name : names) AddOnce(name, names_);
}

Look Palette::Line(const std::string& name, double width) const {
  const auto found = std::find(names_.begin(), names_.end(), name);
  Require(found != names_.end(), "Palette: a name that it was not made for");
  const auto place = static_cast<int>(found - names_.begin());
  constexpr int kDashes = 4;
  return {1 + place % kChartColours, Symbol::kNone, place / kChartColours % kDashes, width};
}

Look Palette::Points(const std::string& name) const {
  Look look = Line(name);
  const int place = look.colour - 1 + kChartColours * look.dash;
  constexpr int kSymbols = 4;
  look.symbol = static_cast<Symbol>(1 + (place + look.dash) % kSymbols);
  return look;
}

}  // namespace cvo::reports
