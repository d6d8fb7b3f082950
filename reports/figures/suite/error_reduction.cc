// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/figures/suite/error_reduction.h"

#include <algorithm>
#include <cmath>

#include "reports/figures/heat_map.h"
#include "reports/figures/numbers.h"
#include "reports/figures/relation.h"
#include "reports/figures/suite/scene_cells.h"
#include "reports/figures/suite/suite_parts.h"

namespace cvo::reports {
namespace {

constexpr std::size_t kMaxRows = 150;
constexpr char kAllScenes[] = "all";

// The part of the table that is drawn: columns with a reduction in at least one row.
struct HeatMap {
  std::vector<std::size_t> columns;
  std::vector<HeatBlock> blocks;  // with cells of these columns only
  std::size_t rows = 0;
};

HeatCell MakeHeatCell(const Cell& cell, const Column& column) {
  HeatCell heat;
  heat.reduction_percent = ErrorReduction(cell, column);
  if (!cell.difference) {
    heat.hover = cell.present ? "nothing in common with the reference" : cell.message;
    return heat;
  }
  const Shown shown = ShownAs(column.metric, column.unit);
  const std::string unit = shown.unit.empty() ? "" : " " + shown.unit;
  heat.distinguishable = cell.difference->distinguishable;
  heat.hover = StrCat(NumberText(shown.scale * cell.difference->value), unit, " against ",
                      NumberText(shown.scale * cell.difference->reference_value), unit, ", ",
                      cell.difference->pairs, " pairs");
  if (!heat.reduction_percent) {
    heat.hover += ": the reference has no error";
    return heat;
  }
  const std::string text = HeatText(*heat.reduction_percent);
  heat.text = heat.distinguishable ? "<b>" + text + "</b>" : "(" + text + ")";
  return heat;
}

HeatRow MakeHeatRow(const std::string& label, const std::vector<Cell>& cells, const Table& table) {
  HeatRow row{label, {}};
  for (std::size_t i = 0; i < cells.size(); ++i) {
    row.cells.push_back(MakeHeatCell(cells[i], table.columns[i]));
  }
  return row;
}

bool HasDifference(const SceneRow& row) {
  return std::any_of(row.cells.begin(), row.cells.end(),
                     [](const Cell& cell) { return cell.difference.has_value(); });
}

std::vector<HeatBlock> MakeBlocks(const std::vector<SeriesRows>& series, const Table& table) {
  std::vector<HeatBlock> blocks;
  for (const SeriesRows& rows : series) {
    HeatBlock block{rows.label, {}};
    for (const SceneRow& scene : rows.scenes) {
      if (HasDifference(scene)) {
        block.rows.push_back(MakeHeatRow(scene.sequence, scene.cells, table));
      }
    }
    if (block.rows.empty()) continue;
    if (rows.all != nullptr && block.rows.size() > 1) {
      block.rows.push_back(MakeHeatRow(kAllScenes, rows.all->cells, table));
    }
    blocks.push_back(std::move(block));
  }
  return blocks;
}

HeatMap MakeHeatMap(const SuiteData& data, const std::vector<SeriesRows>& series) {
  HeatMap map;
  map.blocks = MakeBlocks(series, data.table);
  for (std::size_t i = 0; i < data.table.columns.size(); ++i) {
    const auto has = [i](const HeatRow& row) { return row.cells[i].reduction_percent.has_value(); };
    if (std::any_of(map.blocks.begin(), map.blocks.end(), [&](const HeatBlock& block) {
          return std::any_of(block.rows.begin(), block.rows.end(), has);
        })) {
      map.columns.push_back(i);
    }
  }
  for (HeatBlock& block : map.blocks) {
    for (HeatRow& row : block.rows) {
      std::vector<HeatCell> cells;
      for (const std::size_t column : map.columns) cells.push_back(std::move(row.cells[column]));
      row.cells = std::move(cells);
    }
  }
  for (const HeatBlock& block : map.blocks) map.rows += block.rows.size();
  return map;
}

// The label of a column, with its unit if another column has the same label.
std::string LabelOf(std::size_t index, const Table& table) {
  const Column& column = table.columns[index];
  const auto same = std::count_if(table.columns.begin(), table.columns.end(),
                                  [&](const Column& other) { return other.label == column.label; });
  return same > 1 ? StrCat(column.label, " (", column.unit, ")") : column.label;
}

// The heading of a column. The error of a share is what is missing to 1, so its heading is negated,
// such as "not within<br>10 cm".
std::string ColumnText(std::size_t index, const Table& table) {
  const Column& column = table.columns[index];
  std::string label = LabelOf(index, table);
  if (ShownAs(column.metric, column.unit).is_share) {
    label = label.starts_with("within ") ? "not " + label : "1 − " + label;
  }
  const std::size_t space = label.rfind(' ', label.size() / 2 + 4);
  if (space == std::string::npos) return PlotText(label);
  return PlotText(label.substr(0, space)) + "<br>" + PlotText(label.substr(space + 1));
}

// Describes a block: the number of distinguishable cells, and the largest distinguishable change in
// each direction.
std::string HeatBlockText(const HeatBlock& block, const HeatMap& map, const Table& table) {
  std::size_t cells = 0;
  std::size_t real = 0;
  std::string largest[2];
  double most[2] = {0.0, 0.0};
  for (const HeatRow& row : block.rows) {
    for (std::size_t i = 0; i < row.cells.size(); ++i) {
      const HeatCell& cell = row.cells[i];
      if (!cell.reduction_percent) continue;
      ++cells;
      real += cell.distinguishable ? 1 : 0;
      const int worse = *cell.reduction_percent < 0.0 ? 1 : 0;
      if (!cell.distinguishable || std::abs(*cell.reduction_percent) <= most[worse]) continue;
      most[worse] = std::abs(*cell.reduction_percent);
      largest[worse] = StrCat(NumberText(most[worse], 2), worse ? " % more " : " % less ",
                              LabelOf(map.columns[i], table), " on ", row.label);
    }
  }
  std::string text = StrCat(block.label, ": ", real, " of ", cells, " cells are distinguishable");
  for (const std::string& part : largest) {
    if (!part.empty()) text += ", at most " + part;
  }
  return text + ". ";
}

}  // namespace

std::optional<double> ErrorReduction(const Cell& cell, const Column& column) {
  if (!cell.difference) return std::nullopt;
  const Shown shown = ShownAs(column.metric, column.unit);
  const double reference = cell.difference->reference_value;
  const double before = shown.is_share ? 1.0 - reference : reference;
  const double worse =
      shown.higher_is_better ? -cell.difference->difference : cell.difference->difference;
  if (before <= 0.0) return std::nullopt;
  return -100.0 * worse / before;
}

void DrawErrorReduction(const SuiteData& data, const std::vector<SeriesRows>& series,
                        SuiteDrawing& drawing) {
  const std::string what = "Change in error by sequence: ";
  if (data.table.reference.empty() || data.table.change) {
    drawing.not_drawn.push_back(what + "the suite names no reference to compare with.");
    return;
  }
  const HeatMap map = MakeHeatMap(data, series);
  if (map.columns.empty()) {
    drawing.not_drawn.push_back(StrCat(what, "no sequence has runs both of the reference ",
                                       data.table.reference, " and of another."));
    return;
  }
  if (map.rows > kMaxRows) {
    drawing.not_drawn.push_back(StrCat(what, map.rows, " rows, at most ", kMaxRows, " are drawn."));
    return;
  }
  std::vector<const Column*> columns;
  std::vector<HeatColumn> drawn;
  for (const std::size_t column : map.columns) {
    columns.push_back(&data.table.columns[column]);
    drawn.push_back({LabelOf(column, data.table), ColumnText(column, data.table)});
  }
  const Plot plot = DrawHeatMap(map.blocks, drawn);
  Figure figure;
  figure.id = "error-reduction";
  figure.group = "Change in error";
  figure.title = StrCat("Change in error relative to ", data.table.reference, ", in percent. ",
                        Capitalised(RelationText(columns)));
  figure.caption = StrCat(
      "Blue and −: less error than ", data.table.reference,
      "; orange and +: more, ×12: twelve times as much. In brackets: not distinguishable from it "
      "(the 95 % interval of the "
      "paired difference contains 0, its p-value, corrected for the number of cells, is not below "
      "0.05, or there are too few pairs). Empty: nothing to compare. For shares, the error is the "
      "difference to 100 %. Each cell is based on what both have in common.");
  figure.alt = StrCat("Heat map of ", map.rows, " rows by ", map.columns.size(),
                      " metrics, against ", data.table.reference, ". ");
  for (const HeatBlock& block : map.blocks) figure.alt += HeatBlockText(block, map, data.table);
  figure.alt.pop_back();
  figure.width_px = HeatMapWidth(map.blocks, drawn.size(), 58);
  figure.least_px = HeatMapWidth(map.blocks, drawn.size(), 46);
  figure.height_px = plot.height_px();
  figure.plotly = plot.Text();
  drawing.figures.push_back(std::move(figure));
}

}  // namespace cvo::reports
