// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/tables/columns.h"

#include <algorithm>
#include <set>

#include "core/base/error.h"
#include "reports/results/metric_catalogue.h"

namespace cvo::reports {
namespace {

Contract SharedContract(const RunSummary& run, const MetricValue& metric) {
  return ColumnContract(metric.contract, run.sequence.range());
}

struct Meaning {
  const RunSummary* run;
  const MetricValue* metric;
  Contract contract;
};

void CheckSame(const Meaning& a, const Meaning& b) {
  const auto refuse = [&](const std::string& field, const std::string& in_a,
                          const std::string& in_b) {
    ThrowError("metric " + a.metric->name,
               StrCat(a.run->file.string(), " with ", field, " \"", in_a, "\" and ",
                      b.run->file.string(), " with ", field, " \"", in_b, "\""),
               StrCat("one ", field == "unit" ? "unit" : "contract", " in a table"));
  };
  const std::string field = FirstDifference(a.contract, b.contract);
  if (!field.empty()) {
    refuse(field, FieldText(a.contract, field), FieldText(b.contract, field));
  }
  if (a.metric->unit != b.metric->unit) {
    refuse("unit", NameOf(a.metric->unit), NameOf(b.metric->unit));
  }
}

Meaning WithTruth(Meaning meaning) {
  meaning.contract = WithTruthOf(meaning.contract, meaning.metric->contract);
  return meaning;
}

std::optional<Column> MakeColumn(const std::string& name, const std::vector<SuiteRun>& runs,
                                 bool systems) {
  std::vector<Meaning> kinds;  // the first run, then the first of each other type of dataset
  for (const SuiteRun& run : runs) {
    const MetricValue* metric = run.run ? FindMetric(*run.run, name) : nullptr;
    if (metric == nullptr || run.planned.system != systems) continue;
    const Meaning meaning{&*run.run, metric, SharedContract(*run.run, *metric)};
    if (!kinds.empty()) CheckSame(kinds[0], meaning);
    const auto same_type = std::find_if(kinds.begin(), kinds.end(), [&](const Meaning& kind) {
      return kind.run->sequence.type == meaning.run->sequence.type;
    });
    if (same_type == kinds.end()) {
      kinds.push_back(meaning);
    } else {
      CheckSame(WithTruth(*same_type), WithTruth(meaning));
    }
  }
  if (kinds.empty()) return std::nullopt;
  return Column{name, MetricLabel(name), NameOf(kinds[0].metric->unit), kinds[0].contract};
}

}  // namespace

std::vector<std::string> CameraMetrics() {
  return {"camera_coverage",       "camera_ate",          "camera_rrpe_all_pairs",
          "camera_trpe_all_pairs", "camera_rrpe_1_frame", "camera_trpe_1_frame",
          "camera_t_drift",        "camera_r_drift"};
}

std::vector<std::string> ObjectMetrics() {
  return {
      "camera_ate",         "object_ate",       "object_rrpe_all_pairs", "object_trpe_all_pairs",
      "object_motion_r",    "object_motion_t",  "object_success_10cm",   "object_coverage",
      "object_id_switches", "moving_precision", "moving_recall"};
}

std::vector<std::string> WithCoverage(const std::vector<std::string>& metrics) {
  std::vector<std::string> all;
  const auto has = [](const std::vector<std::string>& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
  };
  for (const std::string& metric : metrics) {
    const std::string coverage = CoverageOf(metric);
    if (!coverage.empty() && !has(metrics, coverage) && !has(all, coverage)) {
      all.push_back(coverage);
    }
    if (!has(all, metric)) all.push_back(metric);
  }
  return all;
}

std::vector<Column> MakeColumns(const std::vector<std::string>& metrics,
                                const std::vector<SuiteRun>& runs) {
  std::vector<Column> columns;
  for (const std::string& name : metrics) {
    std::optional<Column> column = MakeColumn(name, runs, false);
    if (!column) column = MakeColumn(name, runs, true);
    if (column) columns.push_back(std::move(*column));
  }
  return columns;
}

std::string DifferingMeaning(const RowRuns& row, const Column& column) {
  for (const SuiteRun* run : row.runs) {
    const MetricValue* metric = run->run ? FindMetric(*run->run, column.metric) : nullptr;
    if (metric == nullptr) continue;
    const Contract contract = SharedContract(*run->run, *metric);
    const std::string field =
        NameOf(metric->unit) != column.unit ? "unit" : FirstDifference(column.contract, contract);
    if (field.empty()) return "";
    return StrCat(field, " \"", field == "unit" ? NameOf(metric->unit) : FieldText(contract, field),
                  "\"");
  }
  return "";
}

bool AreComparable(const RowRuns& row, const RowRuns& reference, const Column& column) {
  std::set<double> shifts_px;
  bool systems = false;
  for (const RowRuns* runs : {&row, &reference}) {
    for (const SuiteRun* run : runs->runs) {
      if (run->run) shifts_px.insert(run->run->sequence.camera.right_shift_px);
      systems = systems || run->planned.system;
    }
  }
  return DifferingMeaning(row, column).empty() && DifferingMeaning(reference, column).empty() &&
         (!systems || shifts_px.size() <= 1);
}

void CheckSameMetric(const RunSummary& a, const MetricValue& in_a, const RunSummary& b,
                     const MetricValue& in_b) {
  CheckSame({&a, &in_a, in_a.contract}, {&b, &in_b, in_b.contract});
}

}  // namespace cvo::reports
