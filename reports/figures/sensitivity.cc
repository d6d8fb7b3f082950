// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <limits>
#include <optional>
#include <set>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "core/files/text/number.h"
#include "reports/figures/suite_figures.h"

namespace cvo::reports {
namespace {

constexpr std::size_t kMaxLines = 12;
constexpr std::size_t kMaxBands = 6;
constexpr char kDefault[] = "default";

// Rows of a table that differ only in one option, by its value.
struct SweptLine {
  std::string label;                                   // made of the other keys
  std::vector<std::pair<double, std::size_t>> points;  // value, index into Table::rows
};

// The values that a suite tries for one option.
struct SweptOption {
  std::string path;
  std::vector<double> values;           // ascending
  std::optional<double> default_value;  // empty: unknown
  bool log_spaced = false;
  std::vector<SweptLine> lines;
};

// Whether the values span so much that a logarithmic axis is needed.
bool AreLogSpaced(const std::vector<double>& ascending) {
  constexpr double kMinRatio = 10.0;
  return ascending.size() >= 3 && ascending.front() > 0.0 &&
         ascending.back() / ascending.front() >= kMinRatio;
}

// Whether all other options are at their defaults, as in a suite that varies one option at a time.
bool OthersAtDefault(const Table& table, const Row& row, std::size_t key) {
  for (std::size_t i = 0; i < row.keys.size(); ++i) {
    if (i != key && IsOption(table.keys[i]) && row.keys[i] != kDefault) return false;
  }
  return true;
}

std::string LabelOf(const Table& table, const Row& row, std::size_t key, bool one_at_a_time) {
  std::vector<std::string> parts;
  for (std::size_t i = 0; i < row.keys.size(); ++i) {
    const bool option = IsOption(table.keys[i]);
    if (i == key || (one_at_a_time && option)) continue;
    parts.push_back(option ? table.keys[i] + " " + row.keys[i] : row.keys[i]);
  }
  return Joined(parts, ", ");
}

SweptOption ReadOption(const SuitePlan& plan, const Table& table, std::size_t key) {
  SweptOption option;
  option.path = table.keys[key];
  const ChangedOption* changed =
      FindBy(table.provenance.options, &ChangedOption::path, option.path);
  if (changed != nullptr) option.default_value = ParseDouble(changed->default_value);
  const bool one_at_a_time = std::any_of(table.rows.begin(), table.rows.end(), [&](const Row& row) {
    return row.keys[key] != kDefault && OthersAtDefault(table, row, key);
  });
  std::set<double> values;
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    const Row& row = table.rows[i];
    const std::optional<double> value = ParseDouble(row.keys[key]);
    if (!value || (one_at_a_time && !OthersAtDefault(table, row, key))) continue;
    values.insert(*value);
    const std::string label = LabelOf(table, row, key, one_at_a_time);
    FindOrAdd(option.lines, &SweptLine::label, {label.empty() ? OneVariant(plan) : label, {}})
        .points.emplace_back(*value, i);
  }
  option.values.assign(values.begin(), values.end());
  option.log_spaced = AreLogSpaced(option.values);
  for (SweptLine& line : option.lines) std::sort(line.points.begin(), line.points.end());
  return option;
}

// The options with several numeric values that distinguish rows of the table, and why the others
// are not drawn.
std::vector<SweptOption> FindSweptOptions(const SuiteData& data,
                                          std::vector<std::string>& not_drawn) {
  const Table& table = data.table;
  std::vector<SweptOption> options;
  for (std::size_t key = 0; key < table.keys.size(); ++key) {
    if (!IsOption(table.keys[key])) continue;
    SweptOption option = ReadOption(data.plan, table, key);
    const std::string what = StrCat("Sensitivity to ", option.path, ": ");
    if (option.values.size() < 2) {
      not_drawn.push_back(
          StrCat(what, option.values.size(), " numeric values; a curve needs at least 2."));
    } else if (option.lines.size() > kMaxLines) {
      not_drawn.push_back(StrCat(what, option.lines.size(),
                                 " curves would cover each other, at most ", kMaxLines,
                                 " are drawn."));
    } else if (table.columns.empty()) {
      not_drawn.push_back(what + "no result has a metric.");
    } else {
      options.push_back(std::move(option));
    }
  }
  return options;
}

// Columns that belong in one figure. The coverage, if the table has it, is last.
struct MetricGroup {
  std::string name;
  std::vector<std::size_t> columns;
};

bool IsCoverage(const Column& column) { return column.metric.ends_with("coverage"); }

std::string GroupOf(const Column& column) {
  if (column.metric.starts_with("camera_")) return "camera errors";
  if (!column.metric.starts_with("object_")) return "labels of landmarks";
  return ShownAs(column.metric, column.unit).is_error ? "object errors" : "objects found";
}

std::vector<MetricGroup> GroupColumns(const Table& table) {
  std::vector<MetricGroup> groups;
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    if (IsCoverage(table.columns[i])) continue;
    FindOrAdd(groups, &MetricGroup::name, {GroupOf(table.columns[i]), {}}).columns.push_back(i);
  }
  for (MetricGroup& group : groups) {
    const bool camera = group.name == "camera errors";
    const Column* found = FindBy(table.columns, &Column::metric,
                                 std::string(camera ? "camera_coverage" : "object_coverage"));
    if (found) group.columns.push_back(static_cast<std::size_t>(found - table.columns.data()));
  }
  return groups;
}

Panel CurvePanel(const SweptOption& option, const Table& table, std::size_t column,
                 const Palette& palette) {
  const Column& metric = table.columns[column];
  const Shown shown = ShownAs(metric.metric, metric.unit);
  Panel panel;
  panel.x.title = option.path;
  if (option.log_spaced) panel.x = {option.path, AxisScale::kLog, {}, option.values};
  panel.y.title = AxisTitle(metric);
  panel.y.from_zero = true;
  if (shown.is_share) panel.y.low = -4.0;
  if (shown.is_share) panel.y.high = 104.0;
  panel.aspect = IsCoverage(metric) ? 0.22 : 0.27;
  const auto mark = option.default_value;
  if (mark && (!option.log_spaced || *mark > 0.0)) {
    panel.rules = {{*mark, true, "default " + NumberText(*mark)}};
  }
  for (const SweptLine& line : option.lines) {
    Series curve{SeriesKind::kLine, line.label, palette.Points(line.label), {}};
    for (const auto& [value, row] : line.points) {
      const Cell& cell = table.rows[row].cells[column];
      Datum datum{value, std::numeric_limits<double>::quiet_NaN()};
      if (cell.value) datum.y = shown.scale * *cell.value;
      datum.tip = StrCat(line.label, ", ", NumberText(value), ": ", CellValueText(cell, metric));
      if (cell.interval) {
        datum.y_interval = {shown.scale * cell.interval->low, shown.scale * cell.interval->high};
      }
      curve.data.push_back(std::move(datum));
    }
    if (option.lines.size() <= kMaxBands) {
      Series& band = panel.series.emplace_back(curve);
      band.kind = SeriesKind::kBand;
      band.name.clear();
      band.look.opacity = 0.18;
    }
    panel.series.push_back(std::move(curve));
  }
  return panel;
}

Figure SensitivityFigure(const SweptOption& option, const MetricGroup& group, const Table& table,
                         const Palette& palette) {
  Figure figure;
  figure.chart.share_x = true;
  figure.chart.width = 0.75;
  std::vector<const Column*> columns;
  for (const std::size_t column : group.columns) {
    columns.push_back(&table.columns[column]);
    figure.chart.panels.push_back(CurvePanel(option, table, column, palette));
    if (columns.size() > 1 && !figure.chart.panels.back().rules.empty()) {
      figure.chart.panels.back().rules.front().text.clear();
    }
  }
  figure.name = StrCat("sensitivity-", Slug(option.path), "-", Slug(group.name));
  figure.title = StrCat(Capitalised(group.name), " over ", option.path);
  const std::string relation = RelationText(columns);
  if (!relation.empty()) figure.title += ". " + Capitalised(relation);
  figure.caption = StrCat(
      "Points: values of the table. ", IntervalText(table, group.columns),
      option.default_value ? " Dotted: the default, " + NumberText(*option.default_value) + "."
                           : " The default of this option is not known here.",
      IsCoverage(*columns.back()) ? "" : " The suite's table has no coverage for these metrics.");
  return figure;
}

}  // namespace

void AddSensitivity(const SuiteData& data, SuiteFigures& figures) {
  for (const SweptOption& option : FindSweptOptions(data, figures.not_drawn)) {
    std::vector<std::string> names;
    for (const SweptLine& line : option.lines) names.push_back(line.label);
    const Palette palette = PaletteOf(data.plan, names);
    for (const MetricGroup& group : GroupColumns(data.table)) {
      figures.figures.push_back(SensitivityFigure(option, group, data.table, palette));
    }
  }
}

}  // namespace cvo::reports
