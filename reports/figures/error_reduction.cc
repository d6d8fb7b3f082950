// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/figures/error_reduction.h"

#include <algorithm>
#include <cmath>

#include "reports/figures/numbers.h"
#include "reports/figures/plot.h"
#include "reports/figures/relation.h"
#include "reports/figures/scene_cells.h"
#include "reports/figures/suite_parts.h"

namespace cvo::reports {
namespace {

constexpr std::size_t kMaxRows = 150;
constexpr char kAllScenes[] = "all";

struct HeatCell {
  std::optional<double> reduction_percent;
  bool distinguishable = false;
  std::string hover;
};

struct HeatRow {
  std::string label;
  std::vector<HeatCell> cells;  // one per column drawn
};

struct HeatBlock {
  std::string label;
  std::vector<HeatRow> rows;
};

// What remains of the table: columns with a reduction somewhere.
struct HeatMap {
  std::vector<std::size_t> columns;
  std::vector<HeatBlock> blocks;
  double largest_percent = 0.0;
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
  if (!heat.reduction_percent) heat.hover += ": the reference has no error";
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
    bool any = false;
    for (const HeatBlock& block : map.blocks) {
      for (const HeatRow& row : block.rows) {
        if (!row.cells[i].reduction_percent) continue;
        any = true;
        map.largest_percent =
            std::max(map.largest_percent, std::abs(*row.cells[i].reduction_percent));
      }
    }
    if (any) map.columns.push_back(i);
  }
  for (const HeatBlock& block : map.blocks) map.rows += block.rows.size();
  return map;
}

// "−31" of less error, "+31" of more, "×12" from eleven times as much on; in brackets where it may
// be chance.
std::string CellText(const HeatCell& cell) {
  if (!cell.reduction_percent) return "";
  const double percent = std::round(-*cell.reduction_percent);
  std::string text = percent < 0.0 ? "−" : percent > 0.0 ? "+" : "";
  text += NumberText(std::abs(percent), 4);
  if (percent >= 1000.0) text = "×" + NumberText(std::round(1.0 + percent / 100.0), 2);
  return cell.distinguishable ? "<b>" + text + "</b>" : "(" + text + ")";
}

// With the unit where another column has the same label.
std::string LabelOf(std::size_t index, const Table& table) {
  const Column& column = table.columns[index];
  const auto same = std::count_if(table.columns.begin(), table.columns.end(),
                                  [&](const Column& other) { return other.label == column.label; });
  return same > 1 ? StrCat(column.label, " (", column.unit, ")") : column.label;
}

// "not within<br>10 cm" of a share, whose error is what is missing to all.
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

// Places by number: names may be the same, and categories of one name are one.
Json Places(std::size_t count) {
  Json places = Json::array();
  for (std::size_t i = 0; i < count; ++i) places.push_back(i);
  return places;
}

Json NamedPlaces(const Json& names) {
  const double last = static_cast<double>(names.size()) - 0.5;
  return {{"tickvals", Places(names.size())},
          {"ticktext", names},
          {"range", {-0.5, last}},
          {"zeroline", false},
          {"showgrid", false},
          {"showline", false},
          {"ticks", ""}};
}

Json BlockTrace(const HeatBlock& block, const HeatMap& map, const Table& table, double limit) {
  Json values = Json::array();
  Json texts = Json::array();
  Json hovers = Json::array();
  for (const HeatRow& row : block.rows) {
    Json line = Json::array();
    Json line_texts = Json::array();
    Json line_hovers = Json::array();
    for (const std::size_t column : map.columns) {
      const HeatCell& cell = row.cells[column];
      line.push_back(cell.reduction_percent ? Json(Rounded(0.0 - *cell.reduction_percent, 3))
                                            : Json(nullptr));
      line_texts.push_back(CellText(cell));
      line_hovers.push_back(PlotText(
          StrCat(row.label, ", ", block.label, ", ", LabelOf(column, table), ": ", cell.hover)));
    }
    values.push_back(std::move(line));
    texts.push_back(std::move(line_texts));
    hovers.push_back(std::move(line_hovers));
  }
  return {{"type", "heatmap"},
          {"x", Places(map.columns.size())},
          {"y", Places(block.rows.size())},
          {"z", values},
          {"text", texts},
          {"texttemplate", "%{text}"},
          {"customdata", hovers},
          {"coloraxis", "coloraxis"},
          {"textfont", {{"size", 10}}},
          {"xgap", 1},
          {"ygap", 1},
          {"hoverongaps", false},
          {"hovertemplate", "%{customdata}<extra></extra>"},
          {"zmin", -limit},
          {"zmax", limit}};
}

Json ColourAxis(double limit, int length_px) {
  return {
      {"cmin", -limit},
      {"cmax", limit},
      {"cmid", 0},
      {"colorscale",
       {{0.0, "#2166ac"},
        {0.17, "#67a9cf"},
        {0.34, "#d1e5f0"},
        {0.5, "#f7f7f7"},
        {0.66, "#fee0b6"},
        {0.83, "#f1a340"},
        {1.0, "#b35806"}}},
      {"colorbar",
       {{"title", {{"text", "change of<br>error (%)"}, {"side", "top"}, {"font", {{"size", 11}}}}},
        {"thickness", 12},
        {"ticksuffix", ""},
        {"lenmode", "pixels"},
        {"len", length_px}}}};
}

Plot MakePlot(const HeatMap& map, const Table& table) {
  constexpr int kRow_px = 24;
  constexpr int kTop_px = 84;
  constexpr int kBottom_px = 16;
  std::vector<Panel> panels;
  for (const HeatBlock& block : map.blocks) {
    Panel panel{AxisOf(block.label), std::max(kRow_px * static_cast<int>(block.rows.size()), 60)};
    Json names = Json::array();
    for (const HeatRow& row : block.rows) names.push_back(PlotText(row.label));
    panel.y_axis.update(NamedPlaces(names));
    std::reverse(panel.y_axis["range"].begin(), panel.y_axis["range"].end());
    panels.push_back(std::move(panel));
  }
  Json names = Json::array();
  for (const std::size_t column : map.columns) names.push_back(ColumnText(column, table));
  Json x_axis = AxisOf("");
  x_axis.update(NamedPlaces(names));
  x_axis.update({{"side", "top"}, {"tickangle", -45}, {"tickfont", {{"size", 11}}}});
  Plot plot(x_axis, panels, kTop_px, kBottom_px);
  plot.layout()["xaxis"]["anchor"] = "y";
  const double limit = std::clamp(map.largest_percent, 20.0, 100.0);
  for (std::size_t i = 0; i < map.blocks.size(); ++i) {
    plot.AddTrace(i, BlockTrace(map.blocks[i], map, table, limit));
  }
  constexpr int kLeastBar_px = 120;
  const int inner_px = plot.height_px() - kTop_px - kBottom_px;
  plot.layout()["coloraxis"] = ColourAxis(limit, std::max(inner_px, kLeastBar_px));
  return plot;
}

// Per block what is real and the largest change either way.
std::string HeatBlockText(const HeatBlock& block, const HeatMap& map, const Table& table) {
  std::size_t cells = 0;
  std::size_t real = 0;
  std::string largest[2];
  double most[2] = {0.0, 0.0};
  for (const HeatRow& row : block.rows) {
    for (const std::size_t column : map.columns) {
      const HeatCell& cell = row.cells[column];
      if (!cell.reduction_percent) continue;
      ++cells;
      real += cell.distinguishable ? 1 : 0;
      const int worse = *cell.reduction_percent < 0.0 ? 1 : 0;
      if (!cell.distinguishable || std::abs(*cell.reduction_percent) <= most[worse]) continue;
      most[worse] = std::abs(*cell.reduction_percent);
      largest[worse] = StrCat(NumberText(most[worse], 2), worse ? " % more " : " % less ",
                              LabelOf(column, table), " on ", row.label);
    }
  }
  std::string text = StrCat(block.label, ": ", real, " of ", cells, " cells are distinguishable");
  for (const std::string& part : largest) {
    if (!part.empty()) text += ", at most " + part;
  }
  return text + ". ";
}

// With room for the longest name of a row.
int WidthOf(const HeatMap& map, int column_px) {
  constexpr int kLetter_px = 7;
  constexpr int kBesides_px = 150;
  std::size_t longest = 0;
  for (const HeatBlock& block : map.blocks) {
    for (const HeatRow& row : block.rows) longest = std::max(longest, row.label.size());
  }
  return kBesides_px + kLetter_px * static_cast<int>(std::min<std::size_t>(longest, 60)) +
         column_px * static_cast<int>(map.columns.size());
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
  const std::string what = "Change of error by sequence: ";
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
  const Plot plot = MakePlot(map, data.table);
  std::vector<const Column*> columns;
  for (const std::size_t column : map.columns) columns.push_back(&data.table.columns[column]);
  Figure figure;
  figure.id = "error-reduction";
  figure.group = "Change of error";
  figure.title = StrCat("Change of error against ", data.table.reference, ", in percent. ",
                        Capitalised(RelationText(columns)));
  figure.caption = StrCat(
      "Blue and −: less error than ", data.table.reference,
      "; orange and +: more, ×12: twelve times as much. In brackets: not distinguishable from it "
      "(the 95 % interval of the "
      "paired difference holds 0, its p-value, corrected for the number of cells, is not below "
      "0.05, or there are too few pairs). Empty: nothing to compare. Of "
      "shares the error is what is missing to 100 %. Each cell is on what both have in common.");
  figure.alt = StrCat("Heat map of ", map.rows, " rows by ", map.columns.size(),
                      " metrics, against ", data.table.reference, ". ");
  for (const HeatBlock& block : map.blocks) figure.alt += HeatBlockText(block, map, data.table);
  figure.alt.pop_back();
  figure.width_px = WidthOf(map, 58);
  figure.least_px = WidthOf(map, 46);
  figure.height_px = plot.height_px();
  figure.plotly = plot.Text();
  drawing.figures.push_back(std::move(figure));
}

}  // namespace cvo::reports
