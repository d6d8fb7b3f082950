// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// Figures about the cells of the table: change in error, error over coverage, steps.
#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "reports/figures/figure_style.h"
#include "reports/figures/suite_parts.h"

namespace cvo::reports {
namespace {

// "−31" for less error, "+31" for more, and a factor such as "×12" from an increase of 1000 % on.
std::string ChangeText(double change_percent) {
  const double percent = std::round(change_percent);
  if (percent >= 1000.0) return "×" + NumberText(std::round(1.0 + percent / 100.0), 2);
  return (percent < 0.0 ? "−" : percent > 0.0 ? "+" : "") + NumberText(std::abs(percent), 4);
}

// The change against the reference in percent of its error: negative if the error is smaller. For a
// share that should be large, the error is what is missing to 1.
std::optional<double> ChangeOf(const Cell& cell, const Column& column) {
  if (!cell.difference) return std::nullopt;
  const Difference& difference = *cell.difference;
  const Shown shown = ShownAs(column.metric, column.unit);
  const double before =
      shown.is_share ? 1.0 - difference.reference_value : difference.reference_value;
  const double worse = shown.higher_is_better ? -difference.difference : difference.difference;
  return before > 0.0 ? std::optional(100.0 * worse / before) : std::nullopt;
}

bool HasChange(const SceneRow& row) {
  return std::any_of(row.cells.begin(), row.cells.end(),
                     [](const Cell& cell) { return cell.difference.has_value(); });
}

// The columns with a change in at least one row.
std::vector<std::size_t> ChangedColumns(const std::vector<SeriesRows>& series, const Table& table) {
  std::vector<std::size_t> columns;
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    for (const SeriesRows& rows : series) {
      for (const SceneRow& row : rows.scenes) {
        if (ChangeOf(row.cells[i], table.columns[i])) AddOnce(i, columns);
      }
    }
  }
  return columns;
}

// The error of a share is what is missing to 1, so its heading is negated, such as "not within
// 10 cm".
std::string HeadingOf(const Column& column, const Table& table) {
  const std::string label = NameOf(column, table);
  if (!ShownAs(column.metric, column.unit).is_share) return label;
  return label.starts_with("within ") ? "not " + label : "1 − " + label;
}

// Adds a row of a heat map.
void AddChanges(const std::string& label, const std::vector<Cell>& cells,
                const std::vector<std::size_t>& columns, const Table& table, Panel& panel) {
  const auto y = static_cast<int>(panel.y.categories.size());
  panel.y.categories.push_back(label);
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const Column& column = table.columns[columns[i]];
    const Cell& cell = cells[columns[i]];
    const std::optional<double> change = ChangeOf(cell, column);
    if (!change) continue;
    const bool clear = cell.difference->distinguishable;
    const std::string text = ChangeText(*change);
    panel.cells.push_back({static_cast<int>(i), y, *change, clear ? text : "(" + text + ")",
                           StrCat(label, ", ", panel.title, ", ", panel.x.categories[i], ": ",
                                  QuantityText(cell.difference->value, column), " against ",
                                  QuantityText(cell.difference->reference_value, column), ", ",
                                  cell.difference->pairs, " pairs"),
                           clear});
  }
}

// One panel per series, one above the other.
Chart HeatChart(const std::vector<SeriesRows>& series, const std::vector<std::size_t>& columns,
                const Table& table) {
  Chart chart;
  chart.share_x = true;
  std::size_t longest = 0;
  double limit = 10.0;
  for (const SeriesRows& rows : series) {
    Panel panel;
    panel.title = rows.label;
    panel.x.scale = AxisScale::kCategory;
    for (const std::size_t i : columns) {
      panel.x.categories.push_back(HeadingOf(table.columns[i], table));
    }
    panel.y.scale = AxisScale::kCategory;
    for (const SceneRow& scene : rows.scenes) {
      longest = std::max(longest, std::min<std::size_t>(scene.sequence.size(), 60));
      if (HasChange(scene)) AddChanges(scene.sequence, scene.cells, columns, table, panel);
    }
    if (rows.all != nullptr && panel.y.categories.size() > 1) {
      AddChanges("all", rows.all->cells, columns, table, panel);
    }
    for (const HeatCell& cell : panel.cells) limit = std::max(limit, std::abs(cell.value));
    if (!panel.y.categories.empty()) chart.panels.push_back(std::move(panel));
  }
  limit = std::min(limit, 100.0);
  for (Panel& panel : chart.panels) {
    for (HeatCell& cell : panel.cells) cell.value = std::clamp(cell.value / limit, -1.0, 1.0);
  }
  chart.width = std::min(1.0, 0.01 * (5.0 + static_cast<double>(longest + 9 * columns.size())));
  return chart;
}

// Columns of an error metric and of the coverage that it must be read with.
struct ErrorAndCoverage {
  std::size_t error = 0;
  std::size_t coverage = 0;
};

// The first error of the objects and of the camera, with its coverage. If coverage is 100 %
// throughout, the pair shows nothing and is omitted.
std::vector<ErrorAndCoverage> FindPairs(const Table& table, std::vector<std::string>& not_drawn) {
  std::vector<ErrorAndCoverage> pairs;
  const auto find = [&](const auto& is) {
    return static_cast<std::size_t>(std::find_if(table.columns.begin(), table.columns.end(), is) -
                                    table.columns.begin());
  };
  for (const std::string group : {"object", "camera"}) {
    const std::string what = "Error over coverage of the " + group + ": ";
    const std::size_t coverage =
        find([&](const Column& column) { return column.metric == group + "_coverage"; });
    std::size_t error = find([&](const Column& column) { return column.metric == group + "_ate"; });
    if (error == table.columns.size()) {
      error = find([&](const Column& column) {
        return column.metric.starts_with(group + "_") &&
               ShownAs(column.metric, column.unit).is_error;
      });
    }
    if (std::max(coverage, error) == table.columns.size()) {
      not_drawn.push_back(what + "the table lacks one of them.");
    } else if (std::any_of(table.rows.begin(), table.rows.end(), [&](const Row& row) {
                 return row.cells[coverage].present && row.cells[coverage].value < 1.0;
               })) {
      pairs.push_back({error, coverage});
    } else {
      not_drawn.push_back(what + "coverage is 100 % in all rows.");
    }
  }
  return pairs;
}

// A point of a sequence, or of all with their intervals.
std::optional<Datum> PointOf(const std::vector<Cell>& cells, const ErrorAndCoverage& pair,
                             const Table& table, const std::string& what) {
  const Cell& error = cells[pair.error];
  const Cell& coverage = cells[pair.coverage];
  if (!error.present || !coverage.present) return std::nullopt;
  const Column& x = table.columns[pair.coverage];
  const Column& y = table.columns[pair.error];
  const double x_scale = ShownAs(x.metric, x.unit).scale;
  const double y_scale = ShownAs(y.metric, y.unit).scale;
  Datum point{x_scale * coverage.value, y_scale * error.value,
              StrCat(what, ": ", CellValueText(error, y), " at ", CellValueText(coverage, x))};
  point.x_interval = IntervalOf(coverage.interval, x_scale);
  point.y_interval = IntervalOf(error.interval, y_scale);
  return point;
}

Panel CoveragePanel(const SuiteData& data, const std::vector<SeriesRows>& series,
                    const ErrorAndCoverage& pair) {
  const Table& table = data.table;
  std::vector<std::string> names;
  for (const SeriesRows& rows : series) names.push_back(rows.name);
  const Palette palette = PaletteOf(data.plan, names);
  Panel panel;
  panel.x.title = AxisTitle(table.columns[pair.coverage]);
  panel.y.title = AxisTitle(table.columns[pair.error]);
  panel.y.from_zero = true;
  panel.aspect = 0.6;
  std::vector<Series> means;
  for (const SeriesRows& rows : series) {
    Series faint{SeriesKind::kPoints, rows.all ? "" : rows.name, palette.Points(rows.name), {}};
    faint.look.opacity = 0.35;
    for (const SceneRow& scene : rows.scenes) {
      auto point = PointOf(scene.cells, pair, table, rows.label + ", " + scene.sequence);
      if (!point) continue;
      point->x_interval.reset();
      point->y_interval.reset();
      faint.data.push_back(*point);
    }
    panel.series.push_back(std::move(faint));
    const auto mean = rows.all ? PointOf(rows.all->cells, pair, table, rows.label) : std::nullopt;
    if (!mean) continue;
    means.push_back({SeriesKind::kPoints, rows.name, palette.Points(rows.name), {*mean}});
    means.back().data.front().text = rows.options;
  }
  panel.series.insert(panel.series.end(), means.begin(), means.end());
  return panel;
}

// The name of a step is what it adds: the part after "_to_".
std::string StepName(const Row& row) {
  const std::string name = Joined(row.keys, ", ");
  const std::size_t to = name.find("_to_");
  return to == std::string::npos ? name : name.substr(to + 4);
}

Panel StepPanel(const Table& table, std::size_t column) {
  const Shown shown = ShownAs(table.columns[column].metric, table.columns[column].unit);
  Panel panel;
  panel.x.scale = AxisScale::kCategory;
  panel.y.title = AxisTitle(table.columns[column]);
  panel.aspect = 0.18;
  panel.series = {{SeriesKind::kBars, "better", {1}, {}},
                  {SeriesKind::kBars, "worse", {2}, {}},
                  {SeriesKind::kBars, "interval contains 0", {0}, {}}};
  for (const Row& row : table.rows) {
    const auto at = static_cast<double>(panel.x.categories.size());
    panel.x.categories.push_back(StepName(row));
    const std::optional<Difference>& step = row.cells[column].difference;
    if (!step) continue;
    const double before = shown.scale * step->reference_value;
    Datum bar{at, before + shown.scale * step->difference,
              StrCat(StepName(row), ": ", NumberText(before), " to ",
                     NumberText(shown.scale * step->value))};
    bar.base = before;
    bar.y_interval = IntervalOf(step->interval, shown.scale, before);
    const bool decided =
        step->interval && (step->interval->low > 0.0 || step->interval->high < 0.0);
    const bool better = (step->difference > 0.0) == shown.higher_is_better;
    panel.series[!decided ? 2 : better ? 0 : 1].data.push_back(std::move(bar));
  }
  std::erase_if(panel.series, [](const Series& series) { return series.data.empty(); });
  return panel;
}

}  // namespace

void AddErrorReduction(const SuiteData& data, const std::vector<SeriesRows>& series,
                       SuiteFigures& figures) {
  constexpr std::size_t kMaxRows = 150;
  const std::string what = "Change in error by sequence: ";
  const Table& table = data.table;
  if (table.reference.empty() || table.change) {
    figures.not_drawn.push_back(what + "the suite names no reference to compare with.");
    return;
  }
  const std::vector<std::size_t> columns = ChangedColumns(series, table);
  Chart chart = HeatChart(series, columns, table);
  std::size_t rows = 0;
  for (const Panel& panel : chart.panels) rows += panel.y.categories.size();
  if (columns.empty() || rows > kMaxRows) {
    figures.not_drawn.push_back(
        columns.empty() ? StrCat(what, "no sequence has runs both of the reference ",
                                 table.reference, " and of another.")
                        : StrCat(what, rows, " rows, at most ", kMaxRows, " are drawn."));
    return;
  }
  std::vector<const Column*> shown;
  for (const std::size_t i : columns) shown.push_back(&table.columns[i]);
  figures.figures.push_back(
      {"error-reduction",
       StrCat("Change in error relative to ", table.reference, ", in percent. ",
              Capitalised(RelationText(shown))),
       StrCat("Blue and −: less error than ", table.reference,
              "; orange and +: more; ×12: twelve times as much. In brackets: not distinguishable "
              "from it. For shares, the error is the difference to 100 %."),
       std::move(chart)});
}

void AddErrorOverCoverage(const SuiteData& data, const std::vector<SeriesRows>& series,
                          SuiteFigures& figures) {
  constexpr std::size_t kMaxSeries = 20;
  for (const ErrorAndCoverage& pair : FindPairs(data.table, figures.not_drawn)) {
    if (series.size() > kMaxSeries) {
      figures.not_drawn.push_back(StrCat("Error over coverage: ", series.size(),
                                         " kinds of marks, at most ", kMaxSeries,
                                         " can be distinguished."));
      return;
    }
    const Column& error = data.table.columns[pair.error];
    Chart chart;
    chart.width = 0.75;
    chart.panels = {CoveragePanel(data, series, pair)};
    figures.figures.push_back(
        {"error-over-coverage-" + Slug(error.metric),
         StrCat(Capitalised(error.label), " over coverage. ", Capitalised(RelationText({&error}))),
         StrCat("Down and right is better. Full marks: all sequences, with the values of options; "
                "faint marks: one sequence each. ",
                IntervalText(data.table, {pair.error, pair.coverage})),
         std::move(chart)});
  }
}

void AddWaterfall(const SuiteData& data, SuiteFigures& figures) {
  constexpr std::size_t kMostPanels = 6;
  const Table& table = data.table;
  if (table.reference != kRowAbove) return;
  Chart chart;
  chart.share_x = true;
  std::vector<const Column*> columns;
  for (std::size_t i = 0; i < table.columns.size() && columns.size() < kMostPanels; ++i) {
    if (table.columns[i].metric == "camera_coverage") continue;
    Panel panel = StepPanel(table, i);
    if (panel.series.empty()) continue;
    chart.panels.push_back(std::move(panel));
    columns.push_back(&table.columns[i]);
  }
  if (columns.empty()) {
    figures.not_drawn.push_back("Waterfall: no row has a value in common with the row above.");
    return;
  }
  figures.figures.push_back(
      {"waterfall", StrCat("Each row against the row above. ", Capitalised(RelationText(columns))),
       "Each bar goes from the row above to the row, over what both have; its line is the 95 % "
       "interval of the difference, not corrected for the number of steps.",
       std::move(chart)});
}

}  // namespace cvo::reports
