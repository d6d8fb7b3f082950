// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "core/files/json/json.h"
#include "reports/tables/table.h"

namespace cvo::reports {

// A Plotly axis. The title is plain text, which is escaped here.
Json AxisOf(const std::string& title);

struct Panel {
  Json y_axis;
  int height_px = 130;
};

// A panel for a metric. The title of its axis is the metric with its unit.
Panel PanelOf(const Column& column, int height_px);

// Panels one above the other that share the x axis, as the data and layout of Plotly.
class Plot {
 public:
  Plot(Json x_axis, const std::vector<Panel>& panels, int top_px = 44, int bottom_px = 58);

  // Add something to a panel, counted from the top. Unless they say otherwise, the y coordinates of
  // shapes and annotations are fractions of the panel, from 0 at its bottom to 1 at its top.
  void AddTrace(std::size_t panel, Json trace);
  void AddShape(std::size_t panel, Json shape);
  void AddAnnotation(std::size_t panel, Json annotation);

  Json& layout() { return layout_; }
  int height_px() const { return layout_.at("height").get<int>(); }
  // JSON text without "<", so that it can stand inside a <script> element.
  std::string Text() const;

 private:
  Json data_ = Json::array();
  Json layout_;
};

// The height (px) of a legend with these entries above a figure of this width, with room for a
// title below it.
int LegendHeight(const std::vector<std::string>& entries, int width_px);

// JSON text without "<", so that it can stand inside a <script> element.
std::string ScriptJson(const Json& json);
// The same for the data and layout of a plot.
std::string PlotJson(const Json& data, const Json& layout);

// The layout that all figures start from, with the given height and margins.
Json BaseLayout(int height_px, int top_px, int bottom_px);

}  // namespace cvo::reports
