// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/formats/column_panels.h"

#include <algorithm>

namespace cvo::reports {
namespace {

// Returns the columns that adding `column` brings, its coverage included, without those already
// there.
std::vector<std::size_t> Missing(const std::vector<ColumnText>& columns,
                                 const std::vector<std::size_t>& there, std::size_t column) {
  std::vector<std::size_t> missing;
  const auto add = [&](std::size_t index) {
    if (std::find(there.begin(), there.end(), index) == there.end()) missing.push_back(index);
  };
  if (columns[column].coverage) add(*columns[column].coverage);
  add(column);
  return missing;
}

}  // namespace

std::vector<std::vector<std::size_t>> SplitColumns(const std::vector<ColumnText>& columns,
                                                   const std::vector<double>& widths, double room) {
  const auto width_of = [&widths](const std::vector<std::size_t>& some) {
    double sum = 0.0;
    for (const std::size_t column : some) sum += widths[column];
    return sum;
  };
  std::vector<std::vector<std::size_t>> panels = {{}};
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const double more = width_of(Missing(columns, panels.back(), i));
    if (!panels.back().empty() && width_of(panels.back()) + more > room) panels.emplace_back();
    for (const std::size_t column : Missing(columns, panels.back(), i)) {
      panels.back().push_back(column);
    }
  }
  return panels;
}

bool HasValue(const TextLine& line, const std::vector<std::size_t>& columns) {
  return std::any_of(columns.begin(), columns.end(),
                     [&](std::size_t column) { return !line.cells[column].value.empty(); });
}

}  // namespace cvo::reports
