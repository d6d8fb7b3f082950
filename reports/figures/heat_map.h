// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "reports/figures/plot.h"

namespace cvo::reports {

struct HeatCell {
  std::optional<double> reduction_percent;  // of an error; negative: more of it
  bool distinguishable = false;
  std::string text;   // as Plotly reads it
  std::string hover;  // after the names of row, block and column
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
  std::string heading;  // as Plotly reads it
};

// "−31" of less error, "+31" of more, "×12" from eleven times as much on.
std::string HeatText(double reduction_percent);

// Blocks above each other: blue is less error, orange more.
Plot DrawHeatMap(const std::vector<HeatBlock>& blocks, const std::vector<HeatColumn>& columns);

// With room for the longest name of a row.
int HeatMapWidth(const std::vector<HeatBlock>& blocks, std::size_t columns, int column_px);

}  // namespace cvo::reports
