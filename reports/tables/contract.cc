// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/tables/contract.h"

namespace cvo::reports {

Contract ColumnContract(const Contract& contract) {
  Contract column = contract;
  column.erase("truth");
  column.erase("left_out");
  return column;
}

std::string DifferingField(const Contract& a, const Contract& b) {
  for (const auto& [field, value] : a) {
    const auto other = b.find(field);
    if (field == "left_out" || value.empty() || other == b.end() || other->second.empty()) continue;
    if (value != other->second) return field;
  }
  return "";
}

std::vector<std::string> UnstatedFields(const Contract& contract, const Contract& wanted) {
  std::vector<std::string> unstated;
  for (const auto& [field, value] : wanted) {
    const auto found = contract.find(field);
    if (field == "left_out" || value.empty()) continue;
    if (found == contract.end() || found->second.empty()) unstated.push_back(field);
  }
  return unstated;
}

}  // namespace cvo::reports
