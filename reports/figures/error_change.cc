// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// The change in error by sequence and metric, as a heat map.
#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "reports/figures/suite_figures.h"
#include "reports/tables/make_table.h"

namespace cvo::reports {
namespace {

// The part of a table row that belongs to one sequence.
struct SceneRow {
  std::string sequence;
  std::vector<Cell> cells;  // one per column of the table
};

// The rows of the table that share all keys except the sequence.
struct SeriesRows {
  std::string label;         // "full", or "good, full" if rows have more keys
  const Row* all = nullptr;  // row over all sequences; nullptr if the table is by sequence
  std::vector<SceneRow> scenes;
};

std::string LabelOf(const std::vector<std::string>& keys, const std::vector<std::string>& values) {
  std::vector<std::string> parts;
  for (std::size_t i = 0; i < keys.size(); ++i) {
    if (keys[i] == "sequence" || keys[i] == "family") continue;
    parts.push_back(IsOption(keys[i]) ? keys[i] + " " + values[i] : values[i]);
  }
  return Joined(parts, ", ");
}

// Splits the rows of the table by sequence, in the order of the table, with differences against its
// reference.
std::vector<SeriesRows> SplitByScene(const SuiteData& data, const std::vector<RowRuns>& rows,
                                     const std::vector<std::string>& keys) {
  Table table;
  table.keys = keys;
  table.columns = data.table.columns;
  table.reference = data.table.reference;
  SuitePlan plan = data.plan;
  plan.rows = keys;
  const std::string reference = FullReference(plan);
  AddRows(
      rows, ".", [&](const RowRuns& row) { return FindReference(rows, row, keys, reference); },
      table);
  const auto sequence = std::find(keys.begin(), keys.end(), "sequence") - keys.begin();
  std::vector<SeriesRows> series;
  for (Row& row : table.rows) {
    FindOrAdd(series, &SeriesRows::label, {LabelOf(keys, row.keys), nullptr, {}})
        .scenes.push_back({row.keys[static_cast<std::size_t>(sequence)], std::move(row.cells)});
  }
  if (keys.size() == data.table.keys.size()) return series;
  for (const Row& row : data.table.rows) {
    SeriesRows* known = FindBy(series, &SeriesRows::label, LabelOf(data.table.keys, row.keys));
    if (known != nullptr) known->all = &row;
  }
  return series;
}

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

}  // namespace

void AddErrorChange(const SuiteData& data, SuiteFigures& figures) {
  constexpr std::size_t kMaxRows = 200;
  const std::string what = "Change in error by sequence: ";
  const Table& table = data.table;
  if (table.reference.empty() || table.change) {
    figures.not_drawn.push_back(what + "the suite names no reference to compare with.");
    return;
  }
  std::vector<std::string> keys = table.keys;
  AddOnce<std::string>("sequence", keys);
  const std::vector<RowRuns> rows = GroupRuns(data.runs, keys);
  if (rows.size() > kMaxRows) {
    figures.not_drawn.push_back(
        StrCat(what, rows.size(), " rows, at most ", kMaxRows, " are drawn."));
    return;
  }
  const std::vector<SeriesRows> series = SplitByScene(data, rows, keys);
  const std::vector<std::size_t> columns = ChangedColumns(series, table);
  if (columns.empty()) {
    figures.not_drawn.push_back(StrCat(what, "no sequence has runs both of the reference ",
                                       table.reference, " and of another."));
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
       HeatChart(series, columns, table)});
}

}  // namespace cvo::reports
