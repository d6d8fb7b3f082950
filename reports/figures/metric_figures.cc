// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// Figures of the values of a table: paired differences from the reference as a forest plot, and
// metrics over the value of an option.
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <set>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "core/files/text/number.h"
#include "core/record/metric_catalogue.h"
#include "reports/figures/suite_figures.h"
#include "reports/tables/table_texts.h"

namespace cvo::reports {
namespace {

constexpr double kGap = std::numeric_limits<double>::quiet_NaN();

constexpr char kDefault[] = "default";

// "paper, pairwise.alpha 5": the row's keys without options at their default, without the one of
// index `key` and, if only one option is varied at a time, without all options.
std::string LabelOf(const Table& table, const Row& row, std::size_t key, bool one_at_a_time) {
  std::vector<std::string> parts;
  for (std::size_t i = 0; i < row.keys.size(); ++i) {
    const bool option = IsOption(table.keys[i]);
    if (i == key || (option && (one_at_a_time || row.keys[i] == kDefault))) continue;
    parts.push_back(option ? table.keys[i] + " " + row.keys[i] : row.keys[i]);
  }
  return Joined(parts, ", ");
}

// The difference of a cell, if it is drawn.
const Difference* DrawnDifference(const Table& table, const Row& row, std::size_t column) {
  const auto& difference = row.cells[column].difference;
  const bool drawn = difference && difference->interval && IsDrawn(table, row, column);
  return drawn ? &*difference : nullptr;
}

Shown ShownValues(const Table& table, std::size_t column) {
  double largest = 0.0;
  for (const Row& row : table.rows) {
    largest = std::max(largest, std::abs(row.cells[column].value.value_or(0.0)));
  }
  return ShownAs(table.columns[column], largest);
}

// One row per row of the table. Significant differences are coloured, the others grey.
Panel DifferencePanel(const Table& table, const std::vector<const Row*>& rows, std::size_t at) {
  const Column& column = table.columns[at];
  const MetricEntry* entry = FindEntry(column.metric);
  double largest = 0.0;
  for (const Row* row : rows) {
    const Difference* difference = DrawnDifference(table, *row, at);
    if (difference == nullptr) continue;
    largest = std::max(
        {largest, std::abs(difference->interval->low), std::abs(difference->interval->high)});
  }
  const Shown shown = ShownAs(column, largest);
  const Shown of_value = ShownValues(table, at);
  Panel panel;
  panel.title = StrCat(column.label, shown.is_share       ? " (% points)"
                                     : shown.unit.empty() ? ""
                                                          : StrCat(" (", shown.unit, ")"));
  panel.y.scale = AxisScale::kCategory;
  for (const Row* row : rows) {
    panel.y.categories.push_back(LabelOf(table, *row, table.keys.size(), false));
  }
  panel.rule = 0.0;
  for (const auto& [name, colour] :
       {std::pair{"not significant", 0}, std::pair{"better", 3}, std::pair{"worse", 2}}) {
    Series intervals{SeriesKind::kLine, "", {colour, Symbol::kNone, 0, 1.6}, {}};
    Series points{SeriesKind::kPoints, name, {colour, Symbol::kCircle}, {}};
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const Difference* difference = DrawnDifference(table, *rows[i], at);
      if (difference == nullptr) continue;
      const bool better = (difference->difference > 0.0) == (entry && entry->higher_is_better());
      if (colour != (!difference->distinguishable ? 0 : better ? 3 : 2)) continue;
      const auto y = static_cast<double>(i);
      for (const double end : {difference->interval->low, difference->interval->high}) {
        intervals.data.push_back({shown.scale * end, y});
      }
      intervals.data.push_back({kGap, kGap});
      points.data.push_back(
          {shown.scale * difference->difference, y,
           StrCat(panel.y.categories[i], ": ", of_value.Text(difference->value), " against ",
                  of_value.Text(difference->reference_value), ", ", difference->pairs, " pairs")});
    }
    if (points.data.empty()) continue;
    panel.series.push_back(std::move(intervals));
    panel.series.push_back(std::move(points));
  }
  return panel;
}

constexpr std::size_t kMaxLines = 12;
constexpr std::size_t kMaxBands = 6;

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
  std::erase_if(option.lines, [](const SweptLine& line) { return line.points.size() < 2; });
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

// "row_tolerance_px" is in "px".
std::string OptionTitle(const std::string& path) {
  const std::string unit = path.substr(path.rfind('_') + 1);
  const bool known = unit == "m" || unit == "s" || unit == "px" || unit == "rad";
  return known ? StrCat(path.substr(0, path.rfind('_')), " (", unit, ")") : path;
}

Panel CurvePanel(const SweptOption& option, const Table& table, std::size_t column,
                 const Palette& palette) {
  const Column& metric = table.columns[column];
  const Shown shown = ShownValues(table, column);
  Panel panel;
  panel.x.title = OptionTitle(option.path);
  if (option.log_spaced) panel.x = {panel.x.title, AxisScale::kLog, {}, option.values};
  panel.y.title = AxisTitle(metric, shown);
  panel.y.from_zero = true;
  if (shown.is_share) panel.y.low = -4.0;
  if (shown.is_share) panel.y.high = 104.0;
  panel.aspect = 0.4;
  if (option.default_value && (!option.log_spaced || *option.default_value > 0.0)) {
    panel.rule = option.default_value;
  }
  for (const SweptLine& line : option.lines) {
    Series curve{SeriesKind::kLine, line.label, palette.Points(line.label), {}};
    for (const auto& [value, at] : line.points) {
      const Row& row = table.rows[at];
      Datum& datum = curve.data.emplace_back(Datum{value, kGap});
      if (!IsDrawn(table, row, column)) continue;
      const Cell& cell = row.cells[column];
      datum.y = shown.scale * *cell.value;
      datum.tip = StrCat(line.label, ", ", NumberText(value), ": ", shown.Text(*cell.value));
      if (!cell.interval) continue;
      datum.y_interval = {shown.scale * cell.interval->low, shown.scale * cell.interval->high};
      datum.tip += StrCat(" (", NumberText(datum.y_interval->low), " to ",
                          NumberText(datum.y_interval->high), ")");
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

Figure SensitivityFigure(const SweptOption& option, const Table& table, const Palette& palette) {
  Figure figure;
  figure.chart.share_x = true;
  figure.chart.columns = 2;
  std::vector<const Column*> columns;
  for (const std::size_t column : KeyColumns(table)) {
    columns.push_back(&table.columns[column]);
    figure.chart.panels.push_back(CurvePanel(option, table, column, palette));
  }
  Panel& first = figure.chart.panels.front();
  if (first.rule) first.rule_text = "default " + NumberText(*first.rule);
  figure.name = "sensitivity-" + Slug(option.path);
  figure.title = "Metrics over " + option.path;
  const std::string relation = RelationText(columns);
  if (!relation.empty()) figure.title += ". " + Capitalised(relation);
  figure.caption = StrCat("Points: values of the table. Intervals: ", kIntervalMeaning, ".",
                          option.default_value
                              ? " Dotted: the default, " + NumberText(*option.default_value) + "."
                              : " The default of this option is not known here.");
  return figure;
}

// The metrics over the CPU time, with a curve per option through its values.
Figure ParetoFigure(const std::vector<SweptOption>& options, const Table& table, std::size_t cpu) {
  std::vector<std::string> names;
  for (const SweptOption& option : options) names.push_back(option.path);
  const Palette palette(names);
  Figure figure;
  figure.name = "pareto";
  figure.title = "Metrics over CPU time";
  figure.caption =
      "Each curve goes through the values of one option, the others at their defaults.";
  figure.chart.columns = 2;
  for (const std::size_t column : KeyColumns(table)) {
    if (column == cpu) continue;
    const Shown shown = ShownValues(table, column);
    Panel& panel = figure.chart.panels.emplace_back();
    panel.x.title = AxisTitle(table.columns[cpu], ShownAs(table.columns[cpu], 0.0));
    panel.y.title = AxisTitle(table.columns[column], shown);
    panel.aspect = 0.6;
    for (const SweptOption& option : options) {
      for (const SweptLine& line : option.lines) {
        Series curve{SeriesKind::kLine, option.path, palette.Points(option.path), {}};
        for (const auto& [value, at] : line.points) {
          const Row& row = table.rows[at];
          if (!row.cells[cpu].value || !IsDrawn(table, row, column)) continue;
          curve.data.push_back({*row.cells[cpu].value, shown.scale * *row.cells[column].value,
                                StrCat(option.path, " ", NumberText(value))});
        }
        panel.series.push_back(std::move(curve));
      }
    }
  }
  return figure;
}

}  // namespace

void AddAblation(const SuiteData& data, SuiteFigures& figures) {
  constexpr std::size_t kMaxRows = 60;
  const std::string what = "Differences from the reference: ";
  const Table& table = data.table;
  if (table.reference.empty()) {
    figures.not_drawn.push_back(what + "the suite names no reference to compare with.");
    return;
  }
  std::vector<const Row*> rows;
  std::vector<std::size_t> columns;
  for (const std::size_t column : KeyColumns(table)) {
    if (std::ranges::any_of(table.rows, [&](const Row& row) {
          return DrawnDifference(table, row, column) != nullptr;
        })) {
      columns.push_back(column);
    }
  }
  // Another system that is twenty times worse would squeeze the rows that are compared.
  std::set<std::string> systems;
  for (const PlannedRun& run : data.plan.runs) systems.insert(run.system);
  systems.erase("");
  for (const Row& row : table.rows) {
    if (std::ranges::any_of(
            columns,
            [&](std::size_t column) { return DrawnDifference(table, row, column) != nullptr; }) &&
        std::ranges::none_of(row.keys, [&](const auto& key) { return systems.contains(key); })) {
      rows.push_back(&row);
    }
  }
  if (rows.empty() || rows.size() > kMaxRows) {
    figures.not_drawn.push_back(StrCat(what, rows.size(), " rows have one with an interval, 1 to ",
                                       kMaxRows, " are drawn."));
    return;
  }
  Figure& figure = figures.figures.emplace_back();
  figure.chart.columns = 4;
  figure.chart.share_y = true;
  std::vector<const Column*> shown;
  for (const std::size_t i : columns) {
    figure.chart.panels.push_back(DifferencePanel(table, rows, i));
    shown.push_back(&table.columns[i]);
  }
  figure.name = "ablation";
  figure.title =
      StrCat("Paired difference from ", table.reference, ". ", Capitalised(RelationText(shown)));
  figure.caption =
      "Points: mean difference; lines: 95 % intervals. Coloured: significant after correction for "
      "all comparisons of the table. Other systems are in the table alone.";
}

void AddSensitivity(const SuiteData& data, SuiteFigures& figures) {
  const std::vector<SweptOption> options = FindSweptOptions(data, figures.not_drawn);
  const Column* cpu = FindBy(data.table.columns, &Column::metric, kFrameCpu);
  if (!options.empty() && cpu != nullptr) {
    const auto at = static_cast<std::size_t>(cpu - data.table.columns.data());
    figures.figures.push_back(ParetoFigure(options, data.table, at));
  }
  for (const SweptOption& option : options) {
    std::vector<std::string> names;
    for (const SweptLine& line : option.lines) names.push_back(line.label);
    figures.figures.push_back(SensitivityFigure(option, data.table, PaletteOf(data.plan, names)));
  }
}

}  // namespace cvo::reports
