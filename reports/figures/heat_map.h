// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "reports/figures/plot.h"

namespace cvo::reports {

struct HeatCell {
  std::optional<double> reduction_percent;  // of an error; negative: an increase
  bool distinguishable = false;
  std::string text;   // with the markup of Plotly
  std::string hover;  // shown after the names of row, block and column
};

struct HeatRow {
  std::string label;
  std::vector<HeatCell> cells;  // one per column
};

struct HeatBlock {
  std::string label;
  std::vector<HeatRow> rows;
};

struct HeatColumn {
  std::string label;
  std::string heading;  // with the markup of Plotly
};

// The change in error in percent: "−31" for less error, "+31" for more, and a factor such as "×12"
// from an increase of 1000 % on.
std::string HeatText(double reduction_percent);

// Draws the blocks one above the other. Blue is less error, orange more.
Plot DrawHeatMap(const std::vector<HeatBlock>& blocks, const std::vector<HeatColumn>& columns);

// The width of the heat map, with room for the longest name of a row (up to 60 bytes).
int HeatMapWidth(const std::vector<HeatBlock>& blocks, std::size_t columns, int column_px);

}  // namespace cvo::reports
