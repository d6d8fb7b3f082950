// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/gate/baseline.h"

#include <algorithm>
#include <set>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "core/files/sha256.h"
#include "core/record/metric_catalogue.h"
#include "core/record/run_summary.h"
#include "reports/gate/check_runs.h"
#include "reports/tables/cells.h"

namespace cvo::reports {
namespace {

namespace fs = std::filesystem;

void CheckJobs(const Baseline& baseline, const std::string& where) {
  std::set<std::string> metrics;
  for (const BaselineMetric& metric : baseline.metrics) {
    if (FindEntry(metric.name) == nullptr) {
      ThrowError(where + ", metric " + metric.name, "no rule", "a metric that the gate knows");
    }
    if (!metrics.insert(metric.name).second) {
      ThrowError(where + ", metrics", metric.name + " twice", "each metric once");
    }
  }
  std::set<std::pair<RunKeys, std::uint64_t>> seen;
  std::size_t values = 0;
  for (const BaselineJob& job : baseline.jobs) {
    if (!job.keys.contains("variant") || !job.keys.contains("sequence")) {
      ThrowError(where + ", jobs, field keys", Json(job.keys).dump(),
                 "variant and sequence among them");
    }
    if (!seen.insert({job.keys, job.seed}).second) {
      ThrowError(where + ", jobs", StrCat(Json(job.keys).dump(), " with seed ", job.seed, " twice"),
                 "each job once");
    }
    for (const auto& [metric, value] : job.values) {
      if (!metrics.contains(metric)) {
        ThrowError(where + ", jobs", "a value of " + metric, "one of the metrics named above it");
      }
      CheckPossible(metric, value, where + ", jobs");
    }
    values += job.values.size();
  }
  if (values == 0) ThrowError(where, "no value", "something to hold runs against");
  for (const std::uint64_t seed : baseline.seeds) {
    if (FindBy(baseline.jobs, &BaselineJob::seed, seed) != nullptr) continue;
    ThrowError(where + ", field seeds", StrCat(seed), "seeds of its jobs");
  }
  if (baseline.seeds.empty()) {
    ThrowError(where + ", field seeds", "none", "the seeds that checked runs must have");
  }
}

std::string ChecksumOf(Baseline baseline) {
  baseline.checksum.clear();
  return Sha256Hex(FileText(baseline));
}

// Returns the options that all runs share.
std::map<std::string, std::string> SharedOptions(const GateRuns& runs) {
  std::map<std::string, std::string> shared = FlatJson(runs.runs.front().run->options);
  for (const SuiteRun& run : runs.runs) {
    const std::map<std::string, std::string> options = FlatJson(run.run->options);
    std::erase_if(shared, [&](const auto& option) {
      const auto found = options.find(option.first);
      return found == options.end() || found->second != option.second;
    });
  }
  return shared;
}

std::vector<std::uint64_t> GateSeeds(const GateRuns& runs, std::size_t gate_seeds,
                                     const std::string& where) {
  std::set<std::uint64_t> all;
  for (const SuiteRun& run : runs.runs) all.insert(run.planned.seed);
  std::vector<std::uint64_t> seeds(all.begin(), all.end());
  if (seeds.size() < 2) {
    ThrowError(
        where, StrCat(seeds.size(), " seed"),
        "at least two, as of `experiment run --seeds 2`: tolerances are derived from their spread");
  }
  if (gate_seeds > seeds.size()) {
    ThrowError(where, StrCat(seeds.size(), " seeds"),
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

std::vector<BaselineMetric> CollectMetrics(const GateRuns& runs, const std::string& where) {
  std::vector<BaselineMetric> metrics;
  for (const std::string& name : runs.metrics) {
    const bool higher = FindEntry(name)->higher_is_better();
    BaselineMetric metric{name, MetricUnit::kOne, {}, higher ? "higher" : "lower"};
    for (const SuiteRun& run : runs.runs) {
      const MetricValue* value = FindMetric(*run.run, name);
      if (value != nullptr) AddContract(*run.run, *value, metric);
    }
    if (!metric.contracts.empty()) metrics.push_back(std::move(metric));
  }
  if (metrics.empty()) {
    ThrowError(where, "no metric of the suite's table in any result",
               "accuracy or coverage of camera, objects or clustering");
  }
  return metrics;
}

BaselineJob MakeJob(const SuiteRun& run) {
  if (!run.run) {
    ThrowError(RunLabel(run.planned.keys, run.planned.seed),
               run.state + (run.message.empty() ? "" : ": " + run.message),
               "a suite whose jobs are all done: a baseline has no holes");
  }
  const RunSequence& sequence = run.run->sequence;
  BaselineJob job{.keys = run.planned.keys,
                  .seed = run.planned.seed,
                  .type = sequence.type,
                  .content = sequence.content,
                  .images = sequence.images,
                  .frames = sequence.frames,
                  .status = run.state,
                  .values = {}};
  for (const MetricValue& metric : run.run->metrics) job.values[metric.name] = metric.value;
  return job;
}

}  // namespace

Baseline ReadBaseline(const fs::path& file) {
  auto baseline = ReadRecord<Baseline>(file);
  CheckJobs(baseline, file.string());
  if (!baseline.checksum.empty() && baseline.checksum != ChecksumOf(baseline)) {
    ThrowError(file.string(), "a content that does not fit its checksum",
               "a baseline as check --write-baseline wrote it");
  }
  return baseline;
}

std::string BaselineText(const Baseline& baseline) {
  const Json file = FileJson(baseline);
  std::string text;
  for (const auto& [key, value] : file.items()) {
    text += StrCat(text.empty() ? "{\n " : ",\n ", Json(key).dump(), ": ");
    if (key != "metrics" && key != "jobs") {
      text += value.dump();
      continue;
    }
    std::string rows;
    for (const Json& row : value) rows += StrCat(rows.empty() ? "\n  " : ",\n  ", row.dump());
    text += StrCat("[", rows, "\n ]");
  }
  return text + "\n}\n";
}

Baseline MakeBaseline(const fs::path& folder, std::size_t gate_seeds) {
  const GateRuns runs = ReadGateRuns(folder);
  if (runs.runs.empty()) ThrowError(folder.string(), "no job of a variant", "at least one");
  Baseline baseline;
  for (const SuiteRun& run : runs.runs) baseline.jobs.push_back(MakeJob(run));
  const BuildInfo& build = runs.runs.front().run->build;
  baseline.suite = runs.suite;
  baseline.build = {build.identity, build.commit, build.Platform()};
  baseline.seeds = GateSeeds(runs, gate_seeds, folder.string());
  baseline.options = SharedOptions(runs);
  baseline.metrics = CollectMetrics(runs, folder.string());
  baseline.checksum = ChecksumOf(baseline);
  CheckSensitivity(baseline, folder.string());
  return baseline;
}

GateRuns ReadGateRuns(const fs::path& folder, std::vector<std::string> metrics) {
  SuitePlan plan = ReadPlan(folder / "plan.json");
  std::erase_if(plan.runs, [](const PlannedRun& run) { return !run.system.empty(); });
  if (metrics.empty()) {
    metrics = plan.metrics;
    // What no gate may miss (CheckSensitivity), whatever the table shows.
    for (const char* metric : {"camera_ate", "object_success_10cm"})
      AddOnce<std::string>(metric, metrics);
    metrics = WithCoverage(metrics);
  }
  std::erase_if(metrics, [](const std::string& metric) { return !FindEntry(metric); });
  std::vector<SuiteRun> runs = ReadRuns(folder, plan, metrics);
  return {plan.name, std::move(metrics), std::move(runs)};
}

Contract GateContract(const RunSummary& run, const MetricValue& metric) {
  return WithTruthOf(ColumnContract(metric.contract, run.sequence.range()), metric.contract);
}

std::string SceneLabel(const RunKeys& keys) {
  std::string label = keys.at("sequence");
  for (const auto& [key, value] : keys) {
    if (key == "variant" || key == "sequence" || value == "none") continue;
    label += StrCat(", ", key, " ", value);
  }
  return label;
}

std::string RunLabel(const RunKeys& keys, std::uint64_t seed) {
  return StrCat(keys.at("variant"), " on ", SceneLabel(keys), ", seed ", seed);
}

}  // namespace cvo::reports
