// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/figures/figure_style.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "core/files/text/number.h"
#include "core/record/contract.h"
#include "core/record/metric_catalogue.h"

namespace cvo::reports {
namespace {

// Variants with a fixed look. The most used come first, since the first ones never share a colour.
constexpr std::array kKnown = {"full",
                               "2d",
                               "2d3d",
                               "no_gp_prior",
                               "static",
                               "no_pairwise",
                               "no_turn_prior",
                               "no_spatial_track",
                               "no_marginalization",
                               "no_probabilistic_association",
                               "no_box_rematch",
                               "no_label_confidence",
                               "paper",
                               "no_identity"};

std::size_t KnownPlace(const std::string& name) {
  return static_cast<std::size_t>(std::find(kKnown.begin(), kKnown.end(), name) - kKnown.begin());
}

}  // namespace

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
  if (!cell.present) return "no value";
  const std::string text = QuantityText(cell.value, column);
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

std::string Listed(const std::vector<std::string>& texts) {
  std::string list;
  for (std::size_t i = 0; i < texts.size(); ++i) {
    const char* separator = i == 0 ? "" : i + 1 == texts.size() ? " and " : ", ";
    list += StrCat(separator, texts[i]);
  }
  return list;
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
  return Joined(groups, "; ",
                [](const Group& group) { return StrCat(Listed(group.second), ": ", group.first); });
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
  constexpr std::size_t kMost = 3;
  const bool more = meanings.size() > kMost;
  if (more) meanings.resize(kMost);
  return StrCat("Intervals: ", Joined(meanings, "; "), more ? "; others in the table." : ".");
}

Palette::Palette(const std::vector<std::string>& names) {
  std::vector<std::size_t> taken;
  for (const std::string& name : names) taken.push_back(KnownPlace(name));
  std::size_t next = 0;
  for (const std::string& name : names) {
    if (std::find(names_.begin(), names_.end(), name) != names_.end()) continue;
    names_.push_back(name);
    std::size_t place = KnownPlace(name);
    if (place == kKnown.size()) {
      while (std::find(taken.begin(), taken.end(), next) != taken.end()) ++next;
      place = next++;
    }
    places_.push_back(place);
  }
}

Look Palette::Line(const std::string& name, double width) const {
  const auto found = std::find(names_.begin(), names_.end(), name);
  Require(found != names_.end(), "Palette: a name that it was not made for");
  const auto place = static_cast<int>(places_[static_cast<std::size_t>(found - names_.begin())]);
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
