// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/tables/comparisons.h"

#include "reports/statistics/estimate.h"
#include "reports/statistics/paired_test.h"

namespace cvo::reports {

void CorrectForMany(const std::vector<Difference*>& differences) {
  std::vector<Difference*> tested;
  std::vector<double> p_values;
  for (Difference* difference : differences) {
    if (!difference->p_value) continue;
    tested.push_back(difference);
    p_values.push_back(*difference->p_value);
  }
  const std::vector<double> adjusted = HolmAdjusted(p_values);
  for (std::size_t i = 0; i < tested.size(); ++i) {
    Difference& difference = *tested[i];
    difference.adjusted_p_value = adjusted[i];
    const auto& interval = difference.interval;
    difference.distinguishable = interval && (interval->low > 0.0 || interval->high < 0.0) &&
                                 adjusted[i] < 1.0 - kConfidence && difference.pairs >= kMinPairs;
  }
}

void CorrectForMany(Table& table) {
  std::vector<Difference*> differences;
  for (Row& row : table.rows) {
    for (Cell& cell : row.cells) {
      if (cell.difference) differences.push_back(&*cell.difference);
    }
  }
  CorrectForMany(differences);
}

}  // namespace cvo::reports
