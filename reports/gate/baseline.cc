// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/gate/baseline.h"

#include <set>

#include "reports/results/metric_catalogue.h"

namespace cvo::reports {
namespace {

void CheckJobs(const Baseline& baseline, const std::string& where) {
  std::set<std::string> metrics;
  for (const BaselineMetric& metric : baseline.metrics) metrics.insert(metric.name);
  std::set<std::pair<std::map<std::string, std::string>, std::uint64_t>> seen;
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
}

}  // namespace

const char* BaselineMetric::Better(const std::string& name) {
  const MetricEntry* entry = FindEntry(name);
  if (!entry) ThrowError("baseline, metric " + name, "no rule", "a metric that the gate knows");
  return entry->higher_is_better() ? "higher" : "lower";
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

Baseline ReadBaseline(const std::filesystem::path& file) {
  auto baseline = ReadRecord<Baseline>(file);
  CheckJobs(baseline, file.string());
  return baseline;
}

}  // namespace cvo::reports
