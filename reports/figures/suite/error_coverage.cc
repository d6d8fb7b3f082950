// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <set>

#include "reports/figures/numbers.h"
#include "reports/figures/palette.h"
#include "reports/figures/plot.h"
#include "reports/figures/relation.h"
#include "reports/figures/suite/scene_cells.h"
#include "reports/figures/suite/suite_parts.h"
#include "reports/figures/suite/swept_lines.h"

namespace cvo::reports {
namespace {

constexpr std::size_t kMaxSeries = 20;
constexpr int kWidth_px = 560;

// Columns of an error metric and of the coverage that it must be read with.
struct ErrorAndCoverage {
  std::size_t error = 0;
  std::size_t coverage = 0;
};

std::optional<std::size_t> FindColumn(const Table& table, const std::string& metric) {
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    if (table.columns[i].metric == metric) return i;
  }
  return std::nullopt;
}

// The first error of the objects and of the camera, with its coverage. If coverage is 100 %
// throughout, the pair shows nothing and is omitted.
std::vector<ErrorAndCoverage> FindPairs(const Table& table, std::vector<std::string>& not_drawn) {
  std::vector<ErrorAndCoverage> pairs;
  for (const std::string group : {"object", "camera"}) {
    const std::string what = "Error over coverage of the " + group + ": ";
    const auto coverage = FindColumn(table, group + "_coverage");
    auto error = FindColumn(table, group + "_ate");
    for (std::size_t i = 0; i < table.columns.size() && !error; ++i) {
      const Column& column = table.columns[i];
      if (!column.metric.starts_with(group + "_")) continue;
      if (ShownAs(column.metric, column.unit).is_error) error = i;
    }
    if (!coverage || !error) {
      not_drawn.push_back(
          StrCat(what, "the table has no ", error ? "coverage" : "error", " of it."));
      continue;
    }
    const bool varies = std::any_of(table.rows.begin(), table.rows.end(), [&](const Row& row) {
      return row.cells[*coverage].present && row.cells[*coverage].value < 1.0;
    });
    if (varies) {
      pairs.push_back({*error, *coverage});
    } else {
      not_drawn.push_back(what +
                          "coverage is 100 % in all rows, so there is no trade-off to show.");
    }
  }
  return pairs;
}

Json Whiskers(const Cell& cell, double scale, const std::string& colour) {
  if (!cell.interval) return {{"visible", false}};
  return {{"type", "data"},
          {"symmetric", false},
          {"array", {Rounded(scale * std::max(cell.interval->high - cell.value, 0.0))}},
          {"arrayminus", {Rounded(scale * std::max(cell.value - cell.interval->low, 0.0))}},
          {"color", colour},
          {"thickness", 1.5},
          {"width", 4}};
}

double ScaleOf(const Column& column) { return ShownAs(column.metric, column.unit).scale; }

Json ScenePoints(const SeriesRows& series, const Table& table, const ErrorAndCoverage& pair,
                 const Style& style) {
  Json x = Json::array();
  Json y = Json::array();
  Json names = Json::array();
  for (const SceneRow& scene : series.scenes) {
    const Cell& error = scene.cells[pair.error];
    const Cell& coverage = scene.cells[pair.coverage];
    if (!error.present || !coverage.present) continue;
    x.push_back(Rounded(ScaleOf(table.columns[pair.coverage]) * coverage.value));
    y.push_back(Rounded(ScaleOf(table.columns[pair.error]) * error.value));
    names.push_back(PlotText(scene.sequence));
  }
  return {
      {"type", "scatter"},
      {"mode", "markers"},
      {"x", x},
      {"y", y},
      {"text", names},
      {"hovertemplate", StrCat(PlotText(series.label), ", %{text}: %{y} at %{x} %<extra></extra>")},
      {"showlegend", false},
      {"legendgroup", PlotText(series.name)},
      {"marker",
       {{"color", style.colour}, {"symbol", style.symbol}, {"size", 7}, {"opacity", 0.35}}}};
}

Json MeanPoint(const SeriesRows& series, const Table& table, const ErrorAndCoverage& pair,
               const Style& style) {
  const Cell& error = series.all->cells[pair.error];
  const Cell& coverage = series.all->cells[pair.coverage];
  const Column& error_column = table.columns[pair.error];
  const Column& coverage_column = table.columns[pair.coverage];
  const std::string hover = StrCat(series.label, ": ", CellValueText(error, error_column), " at ",
                                   CellValueText(coverage, coverage_column));
  return {{"type", "scatter"},
          {"mode", series.options.empty() ? "markers" : "markers+text"},
          {"name", PlotText(series.name)},
          {"legendgroup", PlotText(series.name)},
          {"x", {Rounded(ScaleOf(coverage_column) * coverage.value)}},
          {"y", {Rounded(ScaleOf(error_column) * error.value)}},
          {"text", {PlotText(series.options)}},
          {"textposition", "top right"},
          {"textfont", {{"size", 10}}},
          {"customdata", {PlotText(hover)}},
          {"hovertemplate", "%{customdata}<extra></extra>"},
          {"error_x", Whiskers(coverage, ScaleOf(coverage_column), style.colour)},
          {"error_y", Whiskers(error, ScaleOf(error_column), style.colour)},
          {"marker", {{"color", style.colour}, {"symbol", style.symbol}, {"size", 11}}}};
}

// Removes texts beside marks that would overlap. The first one stays; the others are shown on
// hovering.
void RemoveOverlappingTexts(Json& points) {
  constexpr double kMinSeparation = 0.04;  // fraction of the range that marks and intervals span
  const auto at = [](const Json& point, const char* axis) { return point[axis][0].get<double>(); };
  const auto span = [&](const char* axis, const char* whiskers) {
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const Json& point : points) {
      const Json& ends = point[whiskers];
      const bool has_ends = ends.contains("array");
      low = std::min(low, at(point, axis) - (has_ends ? ends["arrayminus"][0].get<double>() : 0.0));
      high = std::max(high, at(point, axis) + (has_ends ? ends["array"][0].get<double>() : 0.0));
    }
    return std::max(high - low, 1e-12);
  };
  const double span_x = span("x", "error_x");
  const double span_y = span("y", "error_y");
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      if (points[k]["text"][0] == "") continue;
      if (std::abs(at(points[i], "x") - at(points[k], "x")) > kMinSeparation * span_x) continue;
      if (std::abs(at(points[i], "y") - at(points[k], "y")) > kMinSeparation * span_y) continue;
      points[i]["text"][0] = "";
    }
  }
}

bool HasMean(const SeriesRows& series, const ErrorAndCoverage& pair) {
  return series.all != nullptr && series.all->cells[pair.error].present &&
         series.all->cells[pair.coverage].present;
}

// Lists the series without a mark, such as a variant that finds no object.
std::string WithoutPoint(const std::vector<SeriesRows>& series, const Table& table,
                         const ErrorAndCoverage& pair) {
  std::string text;
  for (const SeriesRows& rows : series) {
    if (rows.all == nullptr || HasMean(rows, pair)) continue;
    text += StrCat(
        " Without a mark: ", rows.label, ", no ", table.columns[pair.error].label, ", coverage ",
        CellValueText(rows.all->cells[pair.coverage], table.columns[pair.coverage]), ".");
  }
  return text;
}

std::string Alt(const std::vector<SeriesRows>& series, const Table& table,
                const ErrorAndCoverage& pair) {
  const Column& error = table.columns[pair.error];
  const Column& coverage = table.columns[pair.coverage];
  std::string text =
      StrCat("Scatter of ", error.label, " over ", coverage.label, "; down and right is better. ");
  for (const SeriesRows& rows : series) {
    if (HasMean(rows, pair)) {
      text +=
          StrCat(Capitalised(rows.label), ": ", CellValueText(rows.all->cells[pair.error], error),
                 " at ", CellValueText(rows.all->cells[pair.coverage], coverage), " coverage. ");
      continue;
    }
    for (const SceneRow& scene : rows.scenes) {
      if (!scene.cells[pair.error].present || !scene.cells[pair.coverage].present) continue;
      text += StrCat(Capitalised(rows.label), " on ", scene.sequence, ": ",
                     CellValueText(scene.cells[pair.error], error), " at ",
                     CellValueText(scene.cells[pair.coverage], coverage), " coverage. ");
    }
  }
  text.pop_back();
  return text;
}

Plot MakePlot(const SuiteData& data, const std::vector<SeriesRows>& series,
              const ErrorAndCoverage& pair) {
  const Table& table = data.table;
  std::vector<std::string> names;
  for (const SeriesRows& rows : series) names.push_back(rows.name);
  const Palette palette = PaletteOf(data.plan, names);
  Panel panel{AxisOf(AxisTitle(table.columns[pair.error])), 300};
  panel.y_axis["rangemode"] = "tozero";
  Plot plot(AxisOf(AxisTitle(table.columns[pair.coverage])), {panel},
            LegendHeight(names, kWidth_px));
  std::set<std::string> in_legend;
  for (const SeriesRows& rows : series) {
    if (rows.all != nullptr && !HasMean(rows, pair)) continue;
    Json points = ScenePoints(rows, table, pair, palette.Of(rows.name));
    if (rows.all == nullptr) {
      points.update(
          {{"showlegend", in_legend.insert(rows.name).second}, {"name", PlotText(rows.name)}});
    }
    plot.AddTrace(0, std::move(points));
  }
  Json means = Json::array();
  for (const SeriesRows& rows : series) {
    if (!HasMean(rows, pair)) continue;
    Json point = MeanPoint(rows, table, pair, palette.Of(rows.name));
    point["showlegend"] = in_legend.insert(rows.name).second;
    means.push_back(std::move(point));
  }
  RemoveOverlappingTexts(means);
  for (Json& point : means) plot.AddTrace(0, std::move(point));
  return plot;
}

// Explains the texts beside the marks.
std::string OptionsText(const Table& table) {
  std::vector<std::string> options;
  for (const std::string& key : table.keys) {
    if (IsOption(key)) options.push_back(key);
  }
  return options.empty() ? "" : StrCat("Numbers: values of ", Listed(options), ". ");
}

Figure DrawPair(const SuiteData& data, const std::vector<SeriesRows>& series,
                const ErrorAndCoverage& pair) {
  const Table& table = data.table;
  const Column& error = table.columns[pair.error];
  const Plot plot = MakePlot(data, series, pair);
  Figure figure;
  figure.id = StrCat("error-over-coverage-", Slug(error.metric));
  figure.group = "Error over coverage";
  figure.title =
      StrCat(Capitalised(error.label), " over coverage. ", Capitalised(RelationText({&error})));
  figure.caption = StrCat(
      "Down and right is better. Full marks: all sequences, with both intervals; "
      "faint marks: one sequence each. ",
      OptionsText(table), IntervalText(table, {pair.error, pair.coverage}),
      WithoutPoint(series, table, pair));
  figure.alt = Alt(series, table, pair);
  figure.width_px = kWidth_px;
  figure.height_px = plot.height_px();
  figure.plotly = plot.Text();
  return figure;
}

}  // namespace

void DrawErrorOverCoverage(const SuiteData& data, const std::vector<SeriesRows>& series,
                           SuiteDrawing& drawing) {
  const std::vector<ErrorAndCoverage> pairs = FindPairs(data.table, drawing.not_drawn);
  if (pairs.empty()) return;
  if (series.size() > kMaxSeries) {
    drawing.not_drawn.push_back(StrCat("Error over coverage: ", series.size(),
                                       " kinds of marks, at most ", kMaxSeries,
                                       " can be distinguished."));
    return;
  }
  for (const ErrorAndCoverage& pair : pairs) {
    drawing.figures.push_back(DrawPair(data, series, pair));
  }
}

}  // namespace cvo::reports
