// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <iterator>
#include <optional>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "reports/figures/numbers.h"
#include "reports/figures/suite_parts.h"

namespace cvo::reports {
namespace {

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
      not_drawn.push_back(StrCat(what, "the table has no ",
                                 error == table.columns.size() ? "error" : "coverage", " of it."));
    } else if (std::any_of(table.rows.begin(), table.rows.end(), [&](const Row& row) {
                 return row.cells[coverage].present && row.cells[coverage].value < 1.0;
               })) {
      pairs.push_back({error, coverage});
    } else {
      not_drawn.push_back(what +
                          "coverage is 100 % in all rows, so there is no trade-off to show.");
    }
  }
  return pairs;
}

std::optional<ValueRange> IntervalOf(const Cell& cell, double scale) {
  if (!cell.interval) return std::nullopt;
  return ValueRange{scale * cell.interval->low, scale * cell.interval->high};
}

// A point of a sequence, or of all with their intervals and the values of options.
std::optional<Datum> PointOf(const std::vector<Cell>& cells, const ErrorAndCoverage& pair,
                             const Table& table, const std::string& what) {
  const Cell& error = cells[pair.error];
  const Cell& coverage = cells[pair.coverage];
  if (!error.present || !coverage.present) return std::nullopt;
  const Column& x = table.columns[pair.coverage];
  const Column& y = table.columns[pair.error];
  return Datum{ShownAs(x.metric, x.unit).scale * coverage.value,
               ShownAs(y.metric, y.unit).scale * error.value,
               StrCat(what, ": ", CellValueText(error, y), " at ", CellValueText(coverage, x))};
}

Panel CoveragePanel(const SuiteData& data, const std::vector<SeriesRows>& series,
                    const ErrorAndCoverage& pair, std::string& without_mark) {
  const Table& table = data.table;
  const Column& x = table.columns[pair.coverage];
  const Column& y = table.columns[pair.error];
  std::vector<std::string> names;
  for (const SeriesRows& rows : series) names.push_back(rows.name);
  const Palette palette = PaletteOf(data.plan, names);
  Panel panel;
  panel.x.title = AxisTitle(x);
  panel.y.title = AxisTitle(y);
  panel.y.from_zero = true;
  panel.aspect = 0.6;
  std::vector<Series> means;
  for (const SeriesRows& rows : series) {
    Series faint{SeriesKind::kPoints, rows.all ? "" : rows.name, palette.Points(rows.name), {}};
    faint.look.opacity = 0.35;
    for (const SceneRow& scene : rows.scenes) {
      const auto point = PointOf(scene.cells, pair, table, rows.label + ", " + scene.sequence);
      if (point) faint.data.push_back(*point);
    }
    const auto mean = rows.all ? PointOf(rows.all->cells, pair, table, rows.label) : std::nullopt;
    if (rows.all && !mean) {
      without_mark += StrCat(" Without a mark: ", rows.label, ", no ", y.label, ", coverage ",
                             CellValueText(rows.all->cells[pair.coverage], x), ".");
      continue;
    }
    panel.series.push_back(std::move(faint));
    if (!mean) continue;
    means.push_back({SeriesKind::kPoints, rows.name, palette.Points(rows.name), {*mean}});
    Datum& datum = means.back().data.front();
    datum.text = rows.options;
    datum.x_interval = IntervalOf(rows.all->cells[pair.coverage], ShownAs(x.metric, x.unit).scale);
    datum.y_interval = IntervalOf(rows.all->cells[pair.error], ShownAs(y.metric, y.unit).scale);
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
    const std::optional<Interval>& interval = step->interval;
    if (interval) {
      bar.y_interval = {before + shown.scale * interval->low,
                        before + shown.scale * interval->high};
    }
    const bool decided = interval && (interval->low > 0.0 || interval->high < 0.0);
    const bool better = (step->difference > 0.0) == shown.higher_is_better;
    panel.series[!decided ? 2 : better ? 0 : 1].data.push_back(std::move(bar));
  }
  std::erase_if(panel.series, [](const Series& series) { return series.data.empty(); });
  return panel;
}

}  // namespace

void AddErrorOverCoverage(const SuiteData& data, const std::vector<SeriesRows>& series,
                          SuiteFigures& figures) {
  constexpr std::size_t kMaxSeries = 20;
  const Table& table = data.table;
  for (const ErrorAndCoverage& pair : FindPairs(table, figures.not_drawn)) {
    if (series.size() > kMaxSeries) {
      figures.not_drawn.push_back(StrCat("Error over coverage: ", series.size(),
                                         " kinds of marks, at most ", kMaxSeries,
                                         " can be distinguished."));
      return;
    }
    const Column& error = table.columns[pair.error];
    std::vector<std::string> options;
    std::copy_if(table.keys.begin(), table.keys.end(), std::back_inserter(options), IsOption);
    std::string without_mark;
    Chart chart;
    chart.width = 0.75;
    chart.panels = {CoveragePanel(data, series, pair, without_mark)};
    figures.figures.push_back(
        {"error-over-coverage-" + Slug(error.metric),
         StrCat(Capitalised(error.label), " over coverage. ", Capitalised(RelationText({&error}))),
         StrCat("Down and right is better. Full marks: all sequences, with both intervals; faint "
                "marks: one sequence each. ",
                options.empty() ? "" : StrCat("Numbers: values of ", Listed(options), ". "),
                IntervalText(table, {pair.error, pair.coverage}), without_mark),
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
       "Each bar goes from the row above to the row, both over what they have in common; its line "
       "is the 95 % interval of the difference. The intervals are not corrected for the number of "
       "steps; the table is.",
       std::move(chart)});
}

}  // namespace cvo::reports
