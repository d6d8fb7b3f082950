// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/record/contract.h"

#include "core/base/error.h"

namespace cvo::reports {
namespace {

// Visits the fields of two contracts pairwise, in their order: visit(name, value in a, value in b).
template <typename Visit>
class PairVisitor {
 public:
  PairVisitor(const Json& other, Visit& visit) : other_(other), visit_(visit) {}

  template <typename T>
  void Optional(const char* key, const std::optional<T>& value) {
    const auto found = other_.find(key);
    visit_(key, ToJson(value), found == other_.end() ? Json() : *found);
  }

 private:
  const Json& other_;
  Visit& visit_;
};

template <typename Visit>
void ForEachField(const Contract& a, const Contract& b, Visit visit) {
  const Json other = ToJson(b);
  PairVisitor<Visit> visitor(other, visit);
  Contract::VisitFields(a, visitor);
}

}  // namespace

Contract ColumnContract(const Contract& contract, const FrameSpan& run) {
  Contract column = WithTruthOf(contract, Contract());
  if (column.frames == run) column.frames = kFramesOfRun;
  return column;
}

Contract WithTruthOf(Contract contract, const Contract& other) {
  contract.truth = other.truth;
  contract.camera_truth = other.camera_truth;
  contract.visible = other.visible;
  contract.right_shift_px = other.right_shift_px;
  return contract;
}

std::string FirstDifference(const Contract& a, const Contract& b) {
  std::string first;
  ForEachField(a, b, [&](const char* name, const Json& in_a, const Json& in_b) {
    if (first.empty() && in_a != in_b) first = name;
  });
  return first;
}

std::string ContradictingField(const Contract& a, const Contract& b) {
  std::string first;
  ForEachField(a, b, [&](const char* name, const Json& in_a, const Json& in_b) {
    if (first.empty() && !in_a.is_null() && !in_b.is_null() && in_a != in_b) first = name;
  });
  return first;
}

std::vector<std::string> UnstatedFields(const Contract& contract, const Contract& wanted) {
  std::vector<std::string> unstated;
  ForEachField(contract, wanted, [&](const char* name, const Json& stated, const Json& asked) {
    if (stated.is_null() && !asked.is_null()) unstated.emplace_back(name);
  });
  return unstated;
}

std::string FieldText(const Contract& contract, const std::string& field) {
  const Json json = ToJson(contract);
  const auto found = json.find(field);
  if (found == json.end()) return "";
  return found->is_string() ? found->get<std::string>() : found->dump();
}

}  // namespace cvo::reports
