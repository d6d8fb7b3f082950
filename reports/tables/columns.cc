// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/tables/columns.h"

#include <array>
#include <utility>

#include "core/base/error.h"

namespace cvo::reports {
namespace {

std::string Label(const std::string& metric) {
  static const std::array<std::pair<const char*, const char*>, 8> labels = {
      {{"camera_coverage", "coverage"},
       {"camera_ate", "ATE"},
       {"camera_rrpe_all_pairs", "R.RPE"},
       {"camera_trpe_all_pairs", "T.RPE"},
       {"camera_rrpe_1_frame", "R.RPE/frame"},
       {"camera_trpe_1_frame", "T.RPE/frame"},
       {"camera_t_drift", "t drift"},
       {"camera_r_drift", "r drift"}}};
  for (const auto& [name, label] : labels) {
    if (metric == name) return label;
  }
  return metric;
}

std::string Describe(const RunSummary& run, const std::string& field, const std::string& value) {
  return StrCat(run.file.string(), " with ", field, " \"", value, "\"");
}

std::string FieldOf(const MetricValue& metric, const std::string& field) {
  const auto found = metric.contract.find(field);
  return found == metric.contract.end() ? "" : found->second;
}

// The definition is the same in all runs of a column, the truth in all of one type of dataset.
void CheckSameMeaning(const RunSummary& a, const MetricValue& in_a, const RunSummary& b,
                      const MetricValue& in_b) {
  std::string field;
  for (const Contract* contract : {&in_a.contract, &in_b.contract}) {
    for (const auto& [name, value] : *contract) {
      const bool may_differ =
          name == "left_out" || (name == "truth" && a.sequence.type != b.sequence.type);
      if (!may_differ && FieldOf(in_a, name) != FieldOf(in_b, name)) field = name;
    }
  }
  if (!field.empty()) {
    ThrowError(StrCat("metric ", in_a.name),
               StrCat(Describe(a, field, FieldOf(in_a, field)), " and ",
                      Describe(b, field, FieldOf(in_b, field))),
               "one contract in a table");
  }
  if (in_a.unit != in_b.unit) {
    ThrowError(StrCat("metric ", in_a.name),
               StrCat(Describe(a, "unit", in_a.unit), " and ", Describe(b, "unit", in_b.unit)),
               "one unit in a table");
  }
}

}  // namespace

std::vector<Column> MakeColumns(const std::vector<std::string>& metrics,
                                const std::vector<const RunSummary*>& runs) {
  std::vector<Column> columns;
  for (const std::string& name : metrics) {
    std::vector<std::pair<const RunSummary*, const MetricValue*>> having;
    for (const RunSummary* run : runs) {
      const MetricValue* metric = FindMetric(*run, name);
      if (metric == nullptr) continue;
      for (const auto& [other, other_metric] : having) {
        CheckSameMeaning(*other, *other_metric, *run, *metric);
      }
      having.emplace_back(run, metric);
    }
    if (having.empty()) continue;
    const MetricValue& first = *having[0].second;
    columns.push_back({name, Label(name), first.unit, ColumnContract(first.contract)});
  }
  return columns;
}

}  // namespace cvo::reports
