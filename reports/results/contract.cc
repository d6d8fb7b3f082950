// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/results/contract.h"

#include "core/base/error.h"

namespace cvo::reports {

Contract ColumnContract(const Contract& contract, int first_frame, int frames) {
  Contract column = contract;
  const std::string range = StrCat("within frames ", first_frame, " to ", first_frame + frames - 1);
  std::string& pairing = column["pairing"];
  const std::size_t at = pairing.find(range);
  if (at != std::string::npos) pairing.replace(at, range.size(), "within the frames of the run");
  if (pairing.empty()) column.erase("pairing");
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
