// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/figures/heat_map.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "core/base/error.h"
#include "reports/figures/numbers.h"

namespace cvo::reports {
namespace {

// Positions on a category axis as numbers: names may repeat, and Plotly merges categories of the
// same name.
Json Places(std::size_t count) {
  Json places = Json::array();
  for (std::size_t i = 0; i < count; ++i) places.push_back(i);
  return places;
}

// The settings of an axis that shows the names at consecutive integer positions from `first` on.
Json NamedPlaces(const Json& names, int first) {
  Json places = Places(names.size());
  for (Json& place : places) place = place.get<int>() + first;
  const double begin = first - 0.5;
  return {{"tickvals", places},
          {"ticktext", names},
          {"range", {begin, begin + static_cast<double>(names.size())}},
          {"zeroline", false},
          {"showgrid", false},
          {"showline", false},
          {"ticks", ""}};
}

Json BlockTrace(const HeatBlock& block, const std::vector<HeatColumn>& columns, double limit) {
  Json values = Json::array();
  Json texts = Json::array();
  Json hovers = Json::array();
  for (const HeatRow& row : block.rows) {
    Json line = Json::array();
    Json line_texts = Json::array();
    Json line_hovers = Json::array();
    for (std::size_t i = 0; i < columns.size(); ++i) {
      const HeatCell& cell = row.cells[i];
      line.push_back(cell.reduction_percent ? Json(Rounded(0.0 - *cell.reduction_percent, 3))
                                            : Json(nullptr));
      line_texts.push_back(cell.text);
      line_hovers.push_back(
          PlotText(StrCat(row.label, ", ", block.label, ", ", columns[i].label, ": ", cell.hover)));
    }
    values.push_back(std::move(line));
    texts.push_back(std::move(line_texts));
    hovers.push_back(std::move(line_hovers));
  }
  return {{"type", "heatmap"},
          {"x", Places(columns.size())},
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
       {{"title", {{"text", "change in<br>error (%)"}, {"side", "top"}, {"font", {{"size", 11}}}}},
        {"thickness", 12},
        {"ticksuffix", ""},
        {"lenmode", "pixels"},
        {"y", 1},
        {"yanchor", "top"},
        {"len", length_px}}}};
}

double LargestChange(const std::vector<HeatBlock>& blocks) {
  double largest = 0.0;
  for (const HeatBlock& block : blocks) {
    for (const HeatRow& row : block.rows) {
      for (const HeatCell& cell : row.cells) {
        largest = std::max(largest, std::abs(cell.reduction_percent.value_or(0.0)));
      }
    }
  }
  return largest;
}

// The name of the block is above its rows: rotated beside them, it would cover that of the next
// block.
Panel BlockPanel(const HeatBlock& block) {
  constexpr int kRow_px = 24;
  Json names = {"<b>" + PlotText(block.label) + "</b>"};
  for (const HeatRow& row : block.rows) names.push_back(PlotText(row.label));
  Panel panel{AxisOf(""), kRow_px * static_cast<int>(names.size())};
  panel.y_axis.update(NamedPlaces(names, -1));
  std::reverse(panel.y_axis["range"].begin(), panel.y_axis["range"].end());
  return panel;
}

}  // namespace

std::string HeatText(double reduction_percent) {
  const double percent = std::round(-reduction_percent);
  if (percent >= 1000.0) return "×" + NumberText(std::round(1.0 + percent / 100.0), 2);
  return (percent < 0.0 ? "−" : percent > 0.0 ? "+" : "") + NumberText(std::abs(percent), 4);
}

namespace {

// The height of the headings, which are rotated by 45 degrees and have one or more lines.
int HeadingHeight(const std::vector<HeatColumn>& columns) {
  constexpr double kLetter_px = 6.5;
  constexpr double kLine_px = 14.0;
  constexpr std::string_view kBreak = "<br>";
  double height_px = 0.0;
  for (const HeatColumn& column : columns) {
    std::size_t longest = 0;
    double lines = 0.0;
    for (std::size_t at = 0; at <= column.heading.size();) {
      const std::size_t end = std::min(column.heading.find(kBreak, at), column.heading.size());
      longest = std::max(longest, end - at);
      lines += 1.0;
      at = end + kBreak.size();
    }
    height_px = std::max(
        height_px, std::sqrt(0.5) * (kLetter_px * static_cast<double>(longest) + kLine_px * lines));
  }
  return static_cast<int>(std::ceil(height_px));
}

}  // namespace

Plot DrawHeatMap(const std::vector<HeatBlock>& blocks, const std::vector<HeatColumn>& columns) {
  constexpr int kLeastTop_px = 84;
  constexpr int kLeastBottom_px = 16;
  constexpr int kLeastBar_px = 110;
  std::vector<Panel> panels;
  int rows_px = 0;
  for (const HeatBlock& block : blocks) {
    panels.push_back(BlockPanel(block));
    rows_px += panels.back().height_px;
  }
  const int top_px = std::max(kLeastTop_px, HeadingHeight(columns) + 16);
  // If the colour bar is longer than the map, Plotly takes the missing space from the headings.
  const int bottom_px = kLeastBottom_px + std::max(0, kLeastBar_px - rows_px);
  Json headings = Json::array();
  for (const HeatColumn& column : columns) headings.push_back(column.heading);
  Json x_axis = AxisOf("");
  x_axis.update(NamedPlaces(headings, 0));
  x_axis.update({{"side", "top"}, {"tickangle", -45}, {"tickfont", {{"size", 11}}}});
  Plot plot(x_axis, panels, top_px, bottom_px);
  plot.layout()["xaxis"]["anchor"] = "y";
  const double limit = std::clamp(LargestChange(blocks), 20.0, 100.0);
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    plot.AddTrace(i, BlockTrace(blocks[i], columns, limit));
  }
  const int inner_px = plot.height_px() - top_px - bottom_px;
  plot.layout()["coloraxis"] = ColourAxis(limit, std::max(inner_px, kLeastBar_px));
  return plot;
}

int HeatMapWidth(const std::vector<HeatBlock>& blocks, std::size_t columns, int column_px) {
  constexpr int kLetter_px = 7;
  constexpr int kBesides_px = 150;
  std::size_t longest = 0;
  for (const HeatBlock& block : blocks) {
    for (const HeatRow& row : block.rows) longest = std::max(longest, row.label.size());
  }
  return kBesides_px + kLetter_px * static_cast<int>(std::min<std::size_t>(longest, 60)) +
         column_px * static_cast<int>(columns);
}

}  // namespace cvo::reports
