// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/figures/figure_style.h"

#include <algorithm>
#include <cctype>
#include <cmath>

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

Shown ShownAs(const std::string& metric, const std::string& unit) {
  const MetricEntry* rule = FindEntry(metric);
  Shown shown{1.0, unit == "1" ? "" : unit, rule && rule->higher_is_better(), false, false};
  if (!rule) return shown;
  shown.is_error = rule->kind == MetricKind::kError;
  shown.is_share = rule->kind == MetricKind::kFraction && unit == "1";
  if (shown.is_share) {
    shown.scale = 100.0;
    shown.unit.assign(1, '%');
  }
  return shown;
}

std::string AxisTitle(const Column& column) {
  const std::string unit = ShownAs(column.metric, column.unit).unit;
  return StrCat(column.label, " (", unit.empty() ? "count" : unit, ")");
}

std::string NameOf(const Column& column, const Table& table) {
  const auto same = std::count_if(table.columns.begin(), table.columns.end(),
                                  [&](const Column& other) { return other.label == column.label; });
  return same > 1 ? StrCat(column.label, " (", column.unit, ")") : column.label;
}

std::string QuantityText(double value, const Column& column) {
  const Shown shown = ShownAs(column.metric, column.unit);
  return StrCat(NumberText(shown.scale * value), shown.unit.empty() ? "" : " ", shown.unit);
}

std::string CellValueText(const Cell& cell, const Column& column) {
  if (!cell.value) return "no value";
  const std::string text = QuantityText(*cell.value, column);
  if (!cell.interval) return text;
  const double scale = ShownAs(column.metric, column.unit).scale;
  return StrCat(text, " (", NumberText(scale * cell.interval->low), " to ",
                NumberText(scale * cell.interval->high), ")");
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
    if (!ShownAs(column->metric, column->unit).is_error) continue;
    const std::string relation = RelationText(column->contract);
    AddOnce(column->label, FindOrAdd(groups, &Group::first, {relation, {}}).second);
  }
  return Joined(groups, "; ", [](const Group& group) {
    return StrCat(Joined(group.second, ", "), ": ", group.first);
  });
}

std::string IntervalText(const Table& table, const std::vector<std::size_t>& columns) {
  std::vector<std::string> meanings;
  for (const Row& row : table.rows) {
    for (const std::size_t column : columns) {
      const auto& interval = row.cells[column].interval;
      if (interval) AddOnce(interval->meaning, meanings);
    }
  }
  if (meanings.empty()) return "No intervals: there is nothing to resample.";
  return StrCat("Intervals: ", Joined(meanings, "; "), ".");
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
  constexpr int kSymbols = 8;
  look.symbol = static_cast<Symbol>(1 + (place + look.dash) % kSymbols);
  return look;
}

}  // namespace cvo::reports
