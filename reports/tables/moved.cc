// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/tables/moved.h"

#include "core/base/error.h"
#include "core/files/number.h"

namespace cvo::reports {
namespace {

std::string Line(const Row& row, const Column& column, const Difference& difference) {
  const std::string unit = column.unit == "1" ? "" : " " + column.unit;
  std::string line = StrCat("  ", RowLabel(row), ", ", column.metric, ": ",
                            FormatSigned(difference.difference, 4), unit);
  if (difference.percent) line += StrCat(" (", FormatSigned(*difference.percent, 4), " %)");
  if (difference.interval) {
    line += StrCat(", ", FormatSigned(difference.interval->low, 4), " to ",
                   FormatSigned(difference.interval->high, 4));
  } else {
    line += ", no interval";
  }
  return StrCat(line, ", ", difference.pairs, difference.pairs == 1 ? " pair" : " pairs", "\n");
}

}  // namespace

std::string MovedText(const Table& table) {
  std::string distinguishable;
  std::string noise;
  for (const Row& row : table.rows) {
    for (std::size_t i = 0; i < row.cells.size(); ++i) {
      const auto& difference = row.cells[i].difference;
      if (!difference || difference->difference == 0.0) continue;
      (difference->distinguishable ? distinguishable : noise) +=
          Line(row, table.columns[i], *difference);
    }
  }
  if (distinguishable.empty() && noise.empty()) return "nothing moved\n";
  std::string text;
  if (!distinguishable.empty()) text += "moved, distinguishable from noise:\n" + distinguishable;
  if (!noise.empty()) text += "moved, not distinguishable from noise:\n" + noise;
  return text;
}

}  // namespace cvo::reports
