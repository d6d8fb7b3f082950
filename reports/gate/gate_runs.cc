// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/gate/gate_runs.h"

#include <algorithm>

#include "core/files/json/json.h"
#include "reports/results/metric_catalogue.h"
#include "reports/results/timing.h"
#include "reports/tables/columns.h"

namespace cvo::reports {
namespace {

namespace fs = std::filesystem;

std::optional<double> EstimateTimeMs(const fs::path& file) {
  try {
    const auto timing = ReadRecord<TimingData>(file);
    const auto estimate = timing.stages.find("estimate");
    if (estimate == timing.stages.end() || estimate->second.median_ms <= 0.0) return std::nullopt;
    return estimate->second.median_ms;
  } catch (const Error&) {
    return std::nullopt;
  }
}

}  // namespace

GateRuns ReadGateRuns(const fs::path& folder, std::vector<std::string> metrics) {
  SuitePlan plan = ReadPlan(folder / "plan.json");
  std::erase_if(plan.runs, [](const PlannedRun& run) { return run.system; });
  if (metrics.empty()) metrics = WithCoverage(plan.metrics);
  std::erase_if(metrics, [](const std::string& metric) { return !FindEntry(metric); });
  GateRuns runs{folder, plan.name, metrics, {}};
  runs.runs = ReadRuns(folder, plan, metrics);
  return runs;
}

Contract GateContract(const RunSummary& run, const MetricValue& metric) {
  return WithTruthOf(ColumnContract(metric.contract, run.sequence.range()), metric.contract);
}

std::string RunLabel(const std::map<std::string, std::string>& keys, std::uint64_t seed) {
  std::string others;
  for (const auto& [key, value] : keys) {
    if (key == "variant" || key == "sequence" || value == "none") continue;
    others += StrCat(", ", key, " ", value);
  }
  return StrCat(keys.at("variant"), " on ", keys.at("sequence"), others, ", seed ", seed);
}

std::map<std::string, double> TimeRatios(const GateRuns& runs) {
  using TimedRun = std::pair<std::map<std::string, std::string>, std::uint64_t>;
  std::map<std::string, double> times_ms;  // by job
  std::map<TimedRun, double> reference_ms;
  for (const SuiteRun& run : runs.runs) {
    if (!run.run) continue;
    const auto time_ms = EstimateTimeMs(runs.folder / "jobs" / run.planned.job / "timing.json");
    if (!time_ms) continue;
    times_ms[run.planned.job] = *time_ms;
    if (KeyOf(run.planned, "variant") != kTimeReference) continue;
    reference_ms[{run.planned.keys, run.planned.seed}] = *time_ms;
  }
  std::map<std::string, double> ratios;
  for (const SuiteRun& run : runs.runs) {
    TimedRun reference_run{run.planned.keys, run.planned.seed};
    reference_run.first["variant"] = kTimeReference;
    const auto time = times_ms.find(run.planned.job);
    const auto reference = reference_ms.find(reference_run);
    if (time == times_ms.end() || reference == reference_ms.end()) continue;
    if (reference_run.first != run.planned.keys)
      ratios[run.planned.job] = time->second / reference->second;
  }
  return ratios;
}

}  // namespace cvo::reports
