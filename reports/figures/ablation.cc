// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// The paired differences of a table from its reference, as a forest plot: a panel per metric.
#include <algorithm>
#include <limits>

#include "core/base/error.h"
#include "reports/figures/suite_figures.h"

namespace cvo::reports {
namespace {

bool HasDifference(const Row& row, std::size_t column) {
  const auto& difference = row.cells[column].difference;
  return difference && difference->interval;
}

// One row per row of the table. Significant differences are coloured, the others grey.
Panel DifferencePanel(const Table& table, const std::vector<const Row*>& rows, std::size_t at) {
  constexpr double kGap = std::numeric_limits<double>::quiet_NaN();
  const Column& column = table.columns[at];
  const Shown shown = ShownAs(column.metric, column.unit);
  Panel panel;
  panel.title = NameOf(column, table);
  panel.x.title = shown.is_share       ? "difference (percentage points)"
                  : shown.unit.empty() ? "difference"
                                       : StrCat("difference (", shown.unit, ")");
  panel.y.scale = AxisScale::kCategory;
  for (const Row* row : rows) panel.y.categories.push_back(RowLabel(*row));
  panel.rules = {{0.0, true}};
  for (const bool significant : {false, true}) {
    const int colour = significant ? 1 : 0;
    Series intervals{SeriesKind::kLine, "", {colour, Symbol::kNone, 0, 1.4}, {}};
    Series points{
        SeriesKind::kPoints, significant ? "significant" : "", {colour, Symbol::kCircle}, {}};
    for (std::size_t i = 0; i < rows.size(); ++i) {
      if (!HasDifference(*rows[i], at)) continue;
      const Difference& difference = *rows[i]->cells[at].difference;
      if (difference.distinguishable != significant) continue;
      const auto y = static_cast<double>(i);
      for (const double end : {difference.interval->low, difference.interval->high}) {
        intervals.data.push_back({shown.scale * end, y});
      }
      intervals.data.push_back({kGap, kGap});
      points.data.push_back(
          {shown.scale * difference.difference, y,
           StrCat(panel.y.categories[i], ": ", QuantityText(difference.value, column), " against ",
                  QuantityText(difference.reference_value, column), ", ", difference.pairs,
                  " pairs")});
    }
    if (points.data.empty()) continue;
    panel.series.push_back(std::move(intervals));
    panel.series.push_back(std::move(points));
  }
  return panel;
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
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    const auto count = std::count_if(table.rows.begin(), table.rows.end(),
                                     [&](const Row& row) { return HasDifference(row, i); });
    if (count > 0) columns.push_back(i);
  }
  for (const Row& row : table.rows) {
    if (std::any_of(columns.begin(), columns.end(),
                    [&](std::size_t column) { return HasDifference(row, column); })) {
      rows.push_back(&row);
    }
  }
  if (rows.empty() || rows.size() > kMaxRows) {
    figures.not_drawn.push_back(StrCat(what, rows.size(), " rows have one with an interval, 1 to ",
                                       kMaxRows, " are drawn."));
    return;
  }
  Chart chart;
  chart.columns = columns.size() > 1 ? 2 : 1;
  chart.share_y = true;
  std::vector<const Column*> shown;
  for (const std::size_t i : columns) {
    chart.panels.push_back(DifferencePanel(table, rows, i));
    shown.push_back(&table.columns[i]);
  }
  figures.figures.push_back(
      {"ablation",
       StrCat("Paired difference from ", table.reference, ". ", Capitalised(RelationText(shown))),
       StrCat("Points: mean difference; lines: 95 % intervals. Coloured: significant after ",
              "correction for all comparisons of the table."),
       std::move(chart)});
}

}  // namespace cvo::reports
