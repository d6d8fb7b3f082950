// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/figures/relation.h"

#include "core/base/error.h"
#include "core/base/lists.h"
#include "reports/figures/numbers.h"
#include "reports/results/contract_text.h"

namespace cvo::reports {
std::string RelationText(const std::vector<const Column*>& columns) {
  using Group = std::pair<std::string, std::vector<std::string>>;  // relation, labels
  std::vector<Group> groups;
  for (const Column* column : columns) {
    if (!ShownAs(column->metric, column->unit).is_error) continue;
    const std::string relation = RelationText(column->contract);
    AddOnce(column->label, FindOrAdd(groups, &Group::first, {relation, {}}).second);
  }
  std::string text;
  for (const auto& [relation, labels] : groups) {
    text += StrCat(text.empty() ? "" : "; ", Listed(labels), ": ", relation);
  }
  return text;
}

std::string IntervalText(const Table& table, const std::vector<std::size_t>& columns) {
  std::vector<std::string> meanings;
  for (const Row& row : table.rows) {
    for (const std::size_t column : columns) {
      const auto& interval = row.cells[column].interval;
      if (interval) AddOnce(interval->meaning, meanings);
    }
  }
  if (meanings.empty()) return "No intervals: there is nothing to resample.";
  std::string text = "Intervals: ";
  for (std::size_t i = 0; i < meanings.size() && i < 3; ++i) {
    text += (i > 0 ? "; " : "") + meanings[i];
  }
  return text + (meanings.size() > 3 ? "; others in the table." : ".");
}

}  // namespace cvo::reports
