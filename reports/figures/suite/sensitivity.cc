// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <optional>
#include <set>

#include "core/base/lists.h"
#include "reports/figures/numbers.h"
#include "reports/figures/palette.h"
#include "reports/figures/plot.h"
#include "reports/figures/relation.h"
#include "reports/figures/suite/suite_parts.h"
#include "reports/figures/suite/swept_lines.h"

namespace cvo::reports {
namespace {

constexpr std::size_t kMaxLines = 12;
constexpr std::size_t kMaxBands = 6;
constexpr int kSweepWidth_px = 620;

// Columns that belong in one figure. The coverage is last.
struct MetricGroup {
  std::string name;
  std::vector<std::size_t> columns;
  bool has_coverage = false;
};

bool IsCoverage(const Column& column) { return column.metric.ends_with("coverage"); }

std::string GroupOf(const Column& column) {
  const Shown shown = ShownAs(column.metric, column.unit);
  if (column.metric.starts_with("camera_")) return "camera errors";
  if (column.metric.starts_with("object_")) {
    return shown.is_error ? "object errors" : "objects found";
  }
  return "labels of landmarks";
}

std::optional<std::size_t> CoverageFor(const std::string& group, const Table& table) {
  const std::string metric = group == "camera errors" ? "camera_coverage" : "object_coverage";
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    if (table.columns[i].metric == metric) return i;
  }
  return std::nullopt;
}

std::vector<MetricGroup> GroupColumns(const Table& table) {
  std::vector<MetricGroup> groups;
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    if (IsCoverage(table.columns[i])) continue;
    const std::string name = GroupOf(table.columns[i]);
    FindOrAdd(groups, &MetricGroup::name, {name, {}, false}).columns.push_back(i);
  }
  for (MetricGroup& group : groups) {
    const auto coverage = CoverageFor(group.name, table);
    group.has_coverage = coverage.has_value();
    if (coverage) group.columns.push_back(*coverage);
  }
  return groups;
}

// The values that get a label on a logarithmic axis. Of values that are too close to each other,
// only the first is labelled.
std::set<double> NamedValues(const std::vector<double>& values) {
  constexpr double kLeastGap = 0.1;  // fraction of the axis
  const std::set<double> ascending(values.begin(), values.end());
  const double least = std::log(*ascending.rbegin() / *ascending.begin()) * kLeastGap;
  std::set<double> named;
  for (const double value : ascending) {
    if (named.empty() || std::log(value / *named.rbegin()) >= least) named.insert(value);
  }
  return named;
}

Json XAxis(const SweptOption& option) {
  Json axis = AxisOf(option.path);
  if (!option.log_spaced) return axis;
  axis["type"] = "log";
  axis["tickvals"] = RoundedList(option.values);
  axis["ticktext"] = Json::array();
  const std::set<double> named = NamedValues(option.values);
  for (const double value : option.values) {
    axis["ticktext"].push_back(named.contains(value) ? NumberText(value, 2) : "");
  }
  return axis;
}

Panel CurvePanel(const Column& column) {
  const Shown shown = ShownAs(column.metric, column.unit);
  Panel panel = PanelOf(column, IsCoverage(column) ? 112 : 130);
  panel.y_axis["rangemode"] = "tozero";
  panel.y_axis["nticks"] = 5;
  if (shown.is_share) panel.y_axis["range"] = {-4, 104};
  return panel;
}

// The area between the two ends of the intervals.
Json Band(const SweptLine& line, const Table& table, std::size_t column, const Style& style) {
  const double scale = ShownAs(table.columns[column].metric, table.columns[column].unit).scale;
  std::vector<double> x;
  std::vector<double> low;
  std::vector<double> high;
  for (const auto& [value, row] : line.points) {
    const Cell& cell = table.rows[row].cells[column];
    if (!cell.present || !cell.interval) continue;
    x.push_back(value);
    low.push_back(scale * cell.interval->low);
    high.push_back(scale * cell.interval->high);
  }
  Json trace = {{"type", "scatter"},      {"mode", "lines"},
                {"hoverinfo", "skip"},    {"fill", "toself"},
                {"showlegend", false},    {"legendgroup", PlotText(line.label)},
                {"line", {{"width", 0}}}, {"fillcolor", Faded(style.colour, 0.2)}};
  std::vector<double> around(x);
  around.insert(around.end(), x.rbegin(), x.rend());
  std::vector<double> edge(low);
  edge.insert(edge.end(), high.rbegin(), high.rend());
  trace["x"] = RoundedList(around);
  trace["y"] = RoundedList(edge);
  return trace;
}

Json Curve(const SweptLine& line, const Table& table, std::size_t column, const Style& style) {
  const Column& metric = table.columns[column];
  const Shown shown = ShownAs(metric.metric, metric.unit);
  Json x = Json::array();
  Json y = Json::array();
  Json texts = Json::array();
  for (const auto& [value, row] : line.points) {
    const Cell& cell = table.rows[row].cells[column];
    x.push_back(Rounded(value));
    y.push_back(cell.present ? Json(Rounded(shown.scale * cell.value)) : Json(nullptr));
    texts.push_back(PlotText(CellValueText(cell, metric)));
  }
  return {{"type", "scatter"},
          {"mode", "lines+markers"},
          {"name", PlotText(line.label)},
          {"legendgroup", PlotText(line.label)},
          {"x", x},
          {"y", y},
          {"text", texts},
          {"hovertemplate", "%{x}: %{text}"},
          {"cliponaxis", false},
          {"line", {{"color", style.colour}, {"dash", style.dash}, {"width", 2}}},
          {"marker", {{"color", style.colour}, {"symbol", style.symbol}, {"size", 7}}}};
}

void MarkDefault(const SweptOption& option, std::size_t panels, Plot& plot) {
  if (!option.default_value) return;
  const double value = *option.default_value;
  if (option.log_spaced && value <= 0.0) return;
  for (std::size_t i = 0; i < panels; ++i) {
    plot.AddShape(i, {{"type", "line"},
                      {"x0", value},
                      {"x1", value},
                      {"y0", 0},
                      {"y1", 1},
                      {"layer", "below"},
                      {"line", {{"color", kTruthColour}, {"dash", "dot"}, {"width", 1.5}}}});
  }
  plot.AddAnnotation(0, {{"xref", "x"},
                         {"x", option.log_spaced ? Rounded(std::log10(value), 8) : value},
                         {"y", 1},
                         {"yanchor", "bottom"},
                         {"text", "default " + NumberText(value)},
                         {"font", {{"size", 11}}}});
}

// Describes a curve: where it starts, where it ends, and where it is best.
std::string CurveText(const SweptLine& line, const Table& table, std::size_t column) {
  const Column& metric = table.columns[column];
  const Shown shown = ShownAs(metric.metric, metric.unit);
  const std::pair<double, std::size_t>* best = nullptr;
  const std::pair<double, std::size_t>* first = nullptr;
  const std::pair<double, std::size_t>* last = nullptr;
  const auto value_of = [&](const auto& point) {
    return table.rows[point.second].cells[column].value;
  };
  for (const auto& point : line.points) {
    if (!table.rows[point.second].cells[column].present) continue;
    if (first == nullptr) first = &point;
    last = &point;
    const bool better =
        best == nullptr || (shown.higher_is_better ? value_of(point) > value_of(*best)
                                                   : value_of(point) < value_of(*best));
    if (better) best = &point;
  }
  if (first == nullptr) return StrCat(metric.label, " of ", line.label, ": no values. ");
  const auto say = [&](const auto& point) {
    return StrCat(CellValueText(table.rows[point.second].cells[column], metric), " at ",
                  NumberText(point.first));
  };
  return StrCat(Capitalised(metric.label), " of ", line.label, ": ", say(*first), ", ", say(*last),
                "; best ", say(*best), ". ");
}

std::string Alt(const SweptOption& option, const MetricGroup& group, const Table& table) {
  std::string text =
      StrCat("Curves over ", option.path, ", ", option.values.size(), " values from ",
             NumberText(option.values.front()), " to ", NumberText(option.values.back()), ". ");
  for (const std::size_t column : group.columns) {
    for (const SweptLine& line : option.lines) text += CurveText(line, table, column);
  }
  text.pop_back();
  return text;
}

std::string Caption(const SweptOption& option, const MetricGroup& group, const Table& table) {
  std::string text = "Points: values of the table";
  text += option.lines.size() <= kMaxBands ? ", bands: their intervals. " : ". ";
  text += IntervalText(table, group.columns);
  text += option.default_value ? " Dotted: the default, " + NumberText(*option.default_value) + "."
                               : " The default of this option is not known here.";
  if (!group.has_coverage) text += " The suite's table has no coverage for these metrics.";
  return text;
}

Figure DrawGroup(const SweptOption& option, const MetricGroup& group, const Table& table,
                 const Palette& palette) {
  std::vector<Panel> panels;
  std::vector<const Column*> columns;
  for (const std::size_t column : group.columns) {
    columns.push_back(&table.columns[column]);
    panels.push_back(CurvePanel(table.columns[column]));
  }
  std::vector<std::string> entries;
  for (const SweptLine& line : option.lines) entries.push_back(line.label);
  constexpr int kDefaultMark_px = 8;
  Plot plot(XAxis(option), panels, LegendHeight(entries, kSweepWidth_px) + kDefaultMark_px);
  for (std::size_t i = 0; i < group.columns.size(); ++i) {
    for (const SweptLine& line : option.lines) {  // all bands are below all curves
      if (option.lines.size() > kMaxBands) break;
      plot.AddTrace(i, Band(line, table, group.columns[i], palette.Of(line.label)));
    }
    for (const SweptLine& line : option.lines) {
      Json curve = Curve(line, table, group.columns[i], palette.Of(line.label));
      curve["showlegend"] = i == 0;
      plot.AddTrace(i, std::move(curve));
    }
  }
  MarkDefault(option, panels.size(), plot);
  Figure figure;
  figure.id = StrCat("sensitivity-", Slug(option.path), "-", Slug(group.name));
  figure.group = "Sensitivity to options";
  figure.title = StrCat(Capitalised(group.name), " over ", option.path);
  const std::string relation = RelationText(columns);
  if (!relation.empty()) figure.title += ". " + Capitalised(relation);
  figure.caption = Caption(option, group, table);
  figure.alt = Alt(option, group, table);
  figure.width_px = kSweepWidth_px;
  figure.height_px = plot.height_px();
  figure.plotly = plot.Text();
  return figure;
}

}  // namespace

void DrawSensitivity(const SuiteData& data, SuiteDrawing& drawing) {
  for (const SweptOption& option : FindSweptOptions(data.plan, data.table, drawing.not_drawn)) {
    if (option.lines.size() > kMaxLines) {
      drawing.not_drawn.push_back(StrCat("Sensitivity to ", option.path, ": ", option.lines.size(),
                                         " curves would cover each other, at most ", kMaxLines,
                                         " are drawn."));
      continue;
    }
    std::vector<std::string> names;
    for (const SweptLine& line : option.lines) names.push_back(line.label);
    const Palette palette = PaletteOf(data.plan, names);
    if (data.table.columns.empty()) {
      drawing.not_drawn.push_back(
          StrCat("Sensitivity to ", option.path, ": no result has a metric."));
    }
    for (const MetricGroup& group : GroupColumns(data.table)) {
      drawing.figures.push_back(DrawGroup(option, group, data.table, palette));
    }
  }
}

}  // namespace cvo::reports
