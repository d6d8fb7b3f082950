// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/gate/make_baseline.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "core/base/error.h"
#include "reports/gate/gate_runs.h"

namespace cvo::reports {
namespace {

void RequireDone(const SuiteRun& run) {
  if (run.run) return;
  const std::string label = RunLabel(run.planned.keys, run.planned.seed);
  ThrowError(label, run.state + (run.message.empty() ? "" : ": " + run.message),
             "a suite whose jobs are all done: a baseline has no holes");
}

std::vector<std::uint64_t> GateSeeds(const GateRuns& runs, std::size_t gate_seeds) {
  std::set<std::uint64_t> all;
  for (const SuiteRun& run : runs.runs) all.insert(run.planned.seed);
  std::vector<std::uint64_t> seeds(all.begin(), all.end());
  if (seeds.size() < 2) {
    ThrowError(runs.folder.string(), StrCat(seeds.size(), " seed"),
               "at least two: tolerances are derived from their spread");
  }
  if (gate_seeds > seeds.size()) {
    ThrowError(runs.folder.string(), StrCat(seeds.size(), " seeds"),
               StrCat("the ", gate_seeds, " that checked runs must have, or more"));
  }
  if (gate_seeds > 0) seeds.resize(gate_seeds);
  return seeds;
}

void AddContract(const RunSummary& run, const MetricValue& value, BaselineMetric& metric) {
  const Contract contract = GateContract(run, value);
  const auto [known, is_new] = metric.contracts.try_emplace(run.sequence.type, contract);
  if (metric.contracts.size() == 1 && is_new) metric.unit = value.unit;
  if (known->second != contract || metric.unit != value.unit) {
    ThrowError(StrCat(run.file.string(), ", metric ", value.name), "another contract or unit",
               StrCat("that of the other runs on ", run.sequence.type));
  }
}

std::vector<BaselineMetric> CollectMetrics(const GateRuns& runs) {
  std::vector<BaselineMetric> metrics;
  for (const std::string& name : runs.metrics) {
    BaselineMetric metric{name, MetricUnit::kOne, {}};
    for (const SuiteRun& run : runs.runs) {
      const MetricValue* value = FindMetric(*run.run, name);
      if (value != nullptr) AddContract(*run.run, *value, metric);
    }
    if (!metric.contracts.empty()) metrics.push_back(std::move(metric));
  }
  if (metrics.empty()) {
    ThrowError(runs.folder.string(), "no metric of the suite's table in any result",
               "accuracy or coverage of camera, objects or clustering");
  }
  return metrics;
}

// Keeps enough digits to compare with, few enough to read.
double Rounded(double ratio) { return std::round(1e4 * ratio) / 1e4; }

BaselineJob MakeJob(const SuiteRun& run, const std::map<std::string, double>& ratios) {
  BaselineJob job;
  job.keys = run.planned.keys;
  job.seed = run.planned.seed;
  job.type = run.run->sequence.type;
  job.content = run.run->sequence.content;
  job.frames = run.run->sequence.frames;
  job.status = run.state;
  for (const MetricValue& metric : run.run->metrics) job.values[metric.name] = metric.value;
  const auto ratio = ratios.find(run.planned.job);
  if (ratio != ratios.end()) job.time_ratio = Rounded(ratio->second);
  return job;
}

}  // namespace

Baseline MakeBaseline(const std::filesystem::path& folder, std::size_t gate_seeds) {
  const GateRuns runs = ReadGateRuns(folder);
  if (runs.runs.empty()) ThrowError(folder.string(), "no job of a variant", "at least one");
  for (const SuiteRun& run : runs.runs) RequireDone(run);
  Baseline baseline;
  baseline.suite = runs.suite;
  const BuildInfo& build = runs.runs.front().run->build;
  baseline.build.identity = build.identity;
  baseline.build.commit = build.commit;
  baseline.build.platform = build.Platform();
  if (!build.cpu_level.empty()) baseline.build.cpu_level = build.cpu_level;
  baseline.seeds = GateSeeds(runs, gate_seeds);
  baseline.metrics = CollectMetrics(runs);
  const std::map<std::string, double> ratios = TimeRatios(runs);
  for (const SuiteRun& run : runs.runs) baseline.jobs.push_back(MakeJob(run, ratios));
  return baseline;
}

}  // namespace cvo::reports
