// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "reports/formats/table_texts.h"

namespace cvo::reports {

// How much of a page a table may take: the text of an A4 page with margins of 15 mm.
inline constexpr double kPanelWidth_pt = 500.0;
inline constexpr std::size_t kPanelLines = 50;
inline constexpr double kColumnGap_pt = 8.0;

// A column of texts at the left.
struct LatexColumn {
  double width_pt = 0.0;
  bool wraps = false;  // longer than a page has room for
};

// A part of a block that fits on a page.
struct LatexPanel {
  std::vector<std::size_t> columns;  // indices, never an accuracy without its coverage
  std::vector<std::size_t> lines;    // indices, those with a value in these columns
};

// Short lines of a heading: words, then the unit.
std::vector<std::string> HeadingLines(const ColumnText& column);

// Widths of the texts of all blocks, together at most half a page.
std::vector<LatexColumn> MeasureTexts(const TableTexts& texts);

// Columns from left to right and lines from top to bottom, as many as fit.
std::vector<LatexPanel> SplitBlock(const TableTexts& texts, const TextBlock& block,
                                   const std::vector<LatexColumn>& columns);

}  // namespace cvo::reports
