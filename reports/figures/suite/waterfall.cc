// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "reports/figures/numbers.h"
#include "reports/figures/plot.h"
#include "reports/figures/relation.h"
#include "reports/figures/suite/suite_parts.h"

namespace cvo::reports {
namespace {

constexpr std::size_t kMostPanels = 6;
constexpr int kPanelHeight_px = 120;
constexpr int kRowWidth_px = 22;
constexpr int kBeside_px = 110;
constexpr int kLeastWidth_px = 420;
constexpr int kLetter_px = 7;

enum Change : std::size_t { kBetter, kWorse, kUndecided };
constexpr std::array<const char*, 3> kNames = {"better", "worse", "interval contains 0"};
constexpr std::array<const char*, 3> kColours = {"#2f7fb8", "#d9772b", "#9a9a9a"};

Change ChangeOf(const Difference& difference, bool higher_is_better) {
  const bool decided =
      difference.interval && (difference.interval->low > 0.0 || difference.interval->high < 0.0);
  if (!decided) return kUndecided;
  return (difference.difference > 0.0) == higher_is_better ? kBetter : kWorse;
}

// The name of a step is what it adds: the part after "_to_".
std::string StepName(const Row& row) {
  const std::string name = Joined(row.keys, ", ");
  const std::size_t to = name.find("_to_");
  return to == std::string::npos ? name : name.substr(to + 4);
}

bool HasSteps(const Table& table, std::size_t column) {
  return std::any_of(table.rows.begin(), table.rows.end(),
                     [&](const Row& row) { return row.cells[column].difference.has_value(); });
}

Json Bars(const Table& table, std::size_t column, Change change) {
  const Shown shown = ShownAs(table.columns[column].metric, table.columns[column].unit);
  Json bars = {{"type", "bar"},
               {"name", kNames.at(change)},
               {"legendgroup", kNames.at(change)},
               {"marker", {{"color", kColours.at(change)}}},
               {"textposition", "none"},
               {"hovertemplate", "%{x}: %{text}"}};
  for (const char* list : {"x", "y", "base", "text"}) bars[list] = Json::array();
  Json above = Json::array();
  Json below = Json::array();
  for (const Row& row : table.rows) {
    const std::optional<Difference>& step = row.cells[column].difference;
    if (!step || ChangeOf(*step, shown.higher_is_better) != change) continue;
    const double difference = shown.scale * step->difference;
    bars["x"].push_back(PlotText(StepName(row)));
    bars["base"].push_back(Rounded(shown.scale * step->reference_value));
    bars["y"].push_back(Rounded(difference));
    bars["text"].push_back(PlotText(StrCat(NumberText(shown.scale * step->reference_value), " to ",
                                           NumberText(shown.scale * step->value))));
    const double high = step->interval ? shown.scale * step->interval->high : difference;
    const double low = step->interval ? shown.scale * step->interval->low : difference;
    above.push_back(Rounded(high - difference));
    below.push_back(Rounded(difference - low));
  }
  bars["error_y"] = {{"type", "data"},      {"symmetric", false}, {"array", above},
                     {"arrayminus", below}, {"thickness", 1},     {"width", 2}};
  return bars;
}

std::string Alt(const Table& table, const std::vector<std::size_t>& columns) {
  std::string text = StrCat("Waterfall of ", table.rows.size(), " steps. ");
  for (const std::size_t column : columns) {
    const Shown shown = ShownAs(table.columns[column].metric, table.columns[column].unit);
    std::array<std::vector<std::string>, 2> steps;
    for (const Row& row : table.rows) {
      const std::optional<Difference>& step = row.cells[column].difference;
      const Change change = step ? ChangeOf(*step, shown.higher_is_better) : kUndecided;
      if (change != kUndecided) steps.at(change).push_back(StepName(row));
    }
    text += StrCat(Capitalised(table.columns[column].label), ": better by ",
                   steps[kBetter].empty() ? "none" : Listed(steps[kBetter]), "; worse by ",
                   steps[kWorse].empty() ? "none" : Listed(steps[kWorse]), ". ");
  }
  text.pop_back();
  return text;
}

}  // namespace

void DrawWaterfall(const SuiteData& data, SuiteDrawing& drawing) {
  const Table& table = data.table;
  if (table.reference != kRowAbove) return;
  std::vector<std::size_t> columns;
  for (std::size_t i = 0; i < table.columns.size() && columns.size() < kMostPanels; ++i) {
    if (HasSteps(table, i) && table.columns[i].metric != "camera_coverage") columns.push_back(i);
  }
  if (columns.empty()) {
    drawing.not_drawn.push_back("Waterfall: no row has a value in common with the row above.");
    return;
  }
  Json x_axis = AxisOf("");
  x_axis["type"] = "category";
  x_axis["tickangle"] = -90;
  x_axis["categoryorder"] = "array";
  std::size_t longest = 0;
  for (const Row& row : table.rows) {
    x_axis["categoryarray"].push_back(PlotText(StepName(row)));
    longest = std::max(longest, StepName(row).size());
  }
  std::vector<Panel> panels;
  std::vector<const Column*> drawn;
  for (const std::size_t column : columns) {
    panels.push_back(PanelOf(table.columns[column], kPanelHeight_px));
    panels.back().y_axis["nticks"] = 5;
    drawn.push_back(&table.columns[column]);
  }
  Figure figure;
  figure.width_px =
      std::max(kBeside_px + kRowWidth_px * static_cast<int>(table.rows.size()), kLeastWidth_px);
  Plot plot(x_axis, panels, LegendHeight({kNames.begin(), kNames.end()}, figure.width_px),
            20 + kLetter_px * static_cast<int>(longest));
  std::array<bool, 3> named{};  // changes that have a legend entry
  for (std::size_t i = 0; i < columns.size(); ++i) {
    for (const Change change : {kBetter, kWorse, kUndecided}) {
      Json bars = Bars(table, columns[i], change);
      bars["showlegend"] = !bars["x"].empty() && !named.at(change);
      if (!bars["x"].empty()) named.at(change) = true;
      plot.AddTrace(i, std::move(bars));
    }
  }
  plot.layout()["barmode"] = "overlay";
  figure.id = "waterfall";
  figure.group = "Step by step";
  figure.title = StrCat("Each row against the row above. ", Capitalised(RelationText(drawn)));
  figure.caption =
      "Each bar goes from the row above to the row, both over what they have in common; its line "
      "is the 95 % interval of the difference. The intervals are not corrected for the number of "
      "steps; the table is.";
  figure.alt = Alt(table, columns);
  figure.least_px = figure.width_px;
  figure.height_px = plot.height_px();
  figure.plotly = plot.Text();
  drawing.figures.push_back(std::move(figure));
}

}  // namespace cvo::reports
