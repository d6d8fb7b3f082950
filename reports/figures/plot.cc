// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/figures/plot.h"

#include <set>

#include "reports/figures/numbers.h"

namespace cvo::reports {
namespace {

constexpr int kGap_px = 16;

std::string AxisName(const char* axis, std::size_t panel, const char* after = "") {
  return panel == 0 ? StrCat(axis, after) : StrCat(axis, panel + 1, after);
}

}  // namespace

Json AxisOf(const std::string& title) {
  return {{"title", {{"text", PlotText(title)}, {"standoff", 8}}},
          {"automargin", true},
          {"zeroline", false},
          {"showline", true},
          {"ticks", "outside"},
          {"exponentformat", "none"},
          {"ticklen", 4}};
}

Panel PanelOf(const Column& column, int height_px) {
  const Shown shown = ShownAs(column.metric, column.unit);
  Panel panel{AxisOf(""), height_px};
  panel.y_axis["title"]["text"] = StrCat(PlotText(column.label), "<br>(",
                                         shown.unit.empty() ? "count" : PlotText(shown.unit), ")");
  panel.y_axis["title"]["font"] = {{"size", 11}};  // larger titles reach into the next panel
  return panel;
}

Json BaseLayout(int height_px, int top_px, int bottom_px) {
  return {{"height", height_px},
          {"margin", {{"l", 70}, {"r", 16}, {"t", top_px}, {"b", bottom_px}}},
          {"font", {{"size", 12}}},
          {"hovermode", "closest"},
          {"legend",
           {{"orientation", "h"},
            {"x", 0},
            {"xanchor", "left"},
            {"y", 1.0},
            {"yref", "container"},
            {"yanchor", "top"}}}};
}

Plot::Plot(Json x_axis, const std::vector<Panel>& panels, int top_px, int bottom_px) {
  int inner_px = kGap_px * (static_cast<int>(panels.size()) - 1);
  for (const Panel& panel : panels) inner_px += panel.height_px;
  layout_ = BaseLayout(inner_px + top_px + bottom_px, top_px, bottom_px);
  x_axis["anchor"] = AxisName("y", panels.size() - 1);
  layout_["xaxis"] = std::move(x_axis);
  int below_px = inner_px;
  for (std::size_t i = 0; i < panels.size(); ++i) {
    Json axis = panels[i].y_axis;
    const double high = static_cast<double>(below_px) / inner_px;
    below_px -= panels[i].height_px;
    const double low = static_cast<double>(below_px) / inner_px;
    axis["domain"] = {Rounded(low, 6), Rounded(high, 6)};
    layout_[AxisName("yaxis", i)] = std::move(axis);
    below_px -= kGap_px;
  }
}

void Plot::AddTrace(std::size_t panel, Json trace) {
  trace["yaxis"] = AxisName("y", panel);
  data_.push_back(std::move(trace));
}

void Plot::AddShape(std::size_t panel, Json shape) {
  shape["xref"] = "x";
  if (!shape.contains("yref")) shape["yref"] = AxisName("y", panel, " domain");
  layout_["shapes"].push_back(std::move(shape));
}

void Plot::AddAnnotation(std::size_t panel, Json annotation) {
  if (!annotation.contains("yref")) annotation["yref"] = AxisName("y", panel, " domain");
  if (!annotation.contains("xref")) annotation["xref"] = "x domain";
  annotation["showarrow"] = false;
  layout_["annotations"].push_back(std::move(annotation));
}

std::string Plot::Text() const { return PlotJson(data_, layout_); }

int LegendHeight(const std::vector<std::string>& entries, int width_px) {
  constexpr int kRow_px = 22;
  constexpr int kBesides_px = 22;
  constexpr int kSymbol_px = 50;
  constexpr int kLetter_px = 7;
  const int room_px = width_px - 110;
  int rows = 1;
  int used_px = 0;
  std::set<std::string> counted;
  for (const std::string& entry : entries) {
    if (!counted.insert(entry).second) continue;
    const int entry_px = kSymbol_px + kLetter_px * static_cast<int>(entry.size());
    if (used_px > 0 && used_px + entry_px > room_px) {
      ++rows;
      used_px = 0;
    }
    used_px += entry_px;
  }
  return kBesides_px + kRow_px * rows;
}

std::string ScriptJson(const Json& json) {
  std::string text;
  for (const char c : json.dump(-1, ' ', false, Json::error_handler_t::replace)) {
    if (c == '<') {
      text += "\\u003c";
    } else {
      text += c;
    }
  }
  return text;
}

std::string PlotJson(const Json& data, const Json& layout) {
  return ScriptJson({{"data", data}, {"layout", layout}});
}

}  // namespace cvo::reports
