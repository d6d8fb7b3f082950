// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "core/files/json/json.h"
#include "reports/tables/table.h"

namespace cvo::reports {

// An axis of Plotly with a title that is text of ours.
Json AxisOf(const std::string& title);

struct Panel {
  Json y_axis;
  int height_px = 130;
};

// Its axis is titled with the metric and its unit.
Panel PanelOf(const Column& column, int height_px);

// Panels above each other that share the x axis, as Plotly's data and layout.
class Plot {
 public:
  Plot(Json x_axis, const std::vector<Panel>& panels, int top_px = 44, int bottom_px = 58);

  // Each to a panel, counted from the top. Shapes and annotations may be in "paper" of it: y from 0
  // at its bottom to 1.
  void AddTrace(std::size_t panel, Json trace);
  void AddShape(std::size_t panel, Json shape);
  void AddAnnotation(std::size_t panel, Json annotation);

  Json& layout() { return layout_; }
  int height_px() const { return layout_.at("height").get<int>(); }
  // Text in which no "<" is left, so that it may stand within a page's script.
  std::string Text() const;

 private:
  Json data_ = Json::array();
  Json layout_;
};

// What a legend of these entries takes above a figure of that width, with a title below it.
int LegendHeight(const std::vector<std::string>& entries, int width_px);

// Text of JSON in which no "<" is left, so that it may stand within a page's script.
std::string ScriptJson(const Json& json);
// The same of data and layout.
std::string PlotJson(const Json& data, const Json& layout);

// The layout that all figures start from.
Json BaseLayout(int height_px, int top_px, int bottom_px);

}  // namespace cvo::reports
