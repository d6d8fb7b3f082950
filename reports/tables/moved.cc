// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/tables/moved.h"

#include <array>
#include <cstdio>

#include "core/base/error.h"

namespace cvo::reports {
namespace {

std::string Signed(double value) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%+.4g", value);
  return text.data();
}

std::string Line(const Row& row, const Column& column, const Difference& difference) {
  const std::string unit = column.unit == "1" ? "" : " " + column.unit;
  std::string line =
      StrCat("  ", RowLabel(row), ", ", column.metric, ": ", Signed(difference.difference), unit);
  if (difference.percent) line += StrCat(" (", Signed(*difference.percent), " %)");
  if (difference.interval) {
    line +=
        StrCat(", ", Signed(difference.interval->low), " to ", Signed(difference.interval->high));
  } else {
    line += ", no interval";
  }
  return StrCat(line, ", ", difference.pairs, difference.pairs == 1 ? " pair" : " pairs", "\n");
}

}  // namespace

std::string MovedText(const Table& table) {
  std::string told;
  std::string noise;
  for (const Row& row : table.rows) {
    for (std::size_t i = 0; i < row.cells.size(); ++i) {
      const auto& difference = row.cells[i].difference;
      if (!difference || difference->difference == 0.0) continue;
      (difference->distinguishable ? told : noise) += Line(row, table.columns[i], *difference);
    }
  }
  if (told.empty() && noise.empty()) return "nothing moved\n";
  std::string text;
  if (!told.empty()) text += "moved, distinguishable from noise:\n" + told;
  if (!noise.empty()) text += "moved, not distinguishable from noise:\n" + noise;
  return text;
}

}  // namespace cvo::reports
