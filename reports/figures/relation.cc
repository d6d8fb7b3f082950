// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/figures/relation.h"

#include <algorithm>

#include "core/base/error.h"
#include "reports/figures/numbers.h"
#include "reports/results/contract_text.h"

namespace cvo::reports {
std::string RelationText(const std::vector<const Column*>& columns) {
  std::vector<std::pair<std::string, std::vector<std::string>>> groups;  // relation, labels
  for (const Column* column : columns) {
    if (!ShownAs(column->metric, column->unit).is_error) continue;
    const std::string relation = RelationText(column->contract);
    auto found = std::find_if(groups.begin(), groups.end(),
                              [&](const auto& group) { return group.first == relation; });
    if (found == groups.end()) found = groups.insert(groups.end(), {relation, {}});
    std::vector<std::string>& labels = found->second;
    if (std::find(labels.begin(), labels.end(), column->label) == labels.end()) {
      labels.push_back(column->label);
    }
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
      if (!interval) continue;
      if (std::find(meanings.begin(), meanings.end(), interval->meaning) == meanings.end()) {
        meanings.push_back(interval->meaning);
      }
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
