// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "reports/tables/table.h"

namespace cvo::reports {

struct GridCell {
  std::string text;
  bool grey = false;  // a figure that does not compare with ours
};

// Rows under a heading.
struct GridBlock {
  std::string heading;
  std::vector<std::vector<GridCell>> rows;
};

// A table as text, before any layout: what every rendering shows.
struct Grid {
  std::size_t text_columns = 0;  // at the left; the rest are numbers
  std::vector<std::string> header;
  std::vector<GridBlock> blocks;  // values, then differences where there are any
  std::vector<std::string> footnotes;
  std::vector<std::string> definitions;  // of the columns
};

Grid MakeGrid(const Table& table);

}  // namespace cvo::reports
