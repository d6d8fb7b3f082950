// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/gate/baseline.h"

#include <cmath>
#include <set>

#include "core/files/json_fields.h"
#include "reports/results/metric_catalogue.h"

namespace cvo::reports {
namespace {

Json ToJson(const BaselineMetric& metric) {
  return {{"name", metric.name},
          {"unit", NameOf(metric.unit)},
          {"better", FindEntry(metric.name)->higher_is_better() ? "higher" : "lower"},
          {"contracts", cvo::ToJson(metric.contracts)}};
}

Json ToJson(const BaselineJob& job) {
  Json json = {{"keys", Json(job.keys)}, {"seed", job.seed},     {"type", job.type},
               {"content", job.content}, {"status", job.status}, {"values", Json::object()}};
  for (const auto& [metric, value] : job.values) {
    if (!std::isfinite(value)) ThrowError("baseline, " + metric, StrCat(value), "a finite number");
    json["values"][metric] = value;
  }
  if (job.time_ratio) json["time_ratio"] = *job.time_ratio;
  return json;
}

template <typename T>
std::string Lines(const std::vector<T>& rows) {
  std::string lines;
  for (const T& row : rows) lines += (lines.empty() ? "\n  " : ",\n  ") + ToJson(row).dump();
  return "[" + lines + "\n ]";
}

BaselineMetric ReadMetric(const Fields& fields) {
  BaselineMetric metric;
  metric.name = fields.Text("name");
  metric.unit = FromJson<MetricUnit>(fields.Text("unit"), fields.where() + ", field unit");
  const MetricEntry* rule = FindEntry(metric.name);
  const std::string better = !rule ? "" : rule->higher_is_better() ? "higher" : "lower";
  if (fields.Text("better") != better) {
    ThrowError(StrCat(fields.where(), ", ", metric.name),
               StrCat("better \"", fields.Text("better"), "\""),
               rule ? StrCat("\"", better, "\"") : "a metric that the gate knows");
  }
  metric.contracts = FromJson<std::map<std::string, Contract>>(fields.Object("contracts").json(),
                                                               fields.where() + ", contracts");
  return metric;
}

BaselineJob ReadJob(const Fields& fields) {
  BaselineJob job;
  job.keys = fields.NamedTexts("keys");
  if (!job.keys.contains("variant") || !job.keys.contains("sequence")) {
    ThrowError(fields.where() + ", field keys", fields.Object("keys").json().dump(),
               "variant and sequence among them");
  }
  job.seed = fields.Count("seed");
  job.type = fields.Text("type");
  job.content = fields.Text("content");
  job.status = fields.Text("status");
  const Fields values = fields.Object("values");
  for (const auto& [metric, value] : values.json().items()) {
    job.values[metric] = values.Number(metric.c_str());
  }
  if (fields.Has("time_ratio")) job.time_ratio = fields.Number("time_ratio");
  return job;
}

void CheckJobs(const Baseline& baseline, const std::string& where) {
  std::set<std::string> metrics;
  for (const BaselineMetric& metric : baseline.metrics) metrics.insert(metric.name);
  std::set<std::pair<std::map<std::string, std::string>, std::uint64_t>> seen;
  std::size_t values = 0;
  for (const BaselineJob& job : baseline.jobs) {
    if (!seen.insert({job.keys, job.seed}).second) {
      ThrowError(where + ", jobs", StrCat(Json(job.keys).dump(), " with seed ", job.seed, " twice"),
                 "each job once");
    }
    for (const auto& [metric, value] : job.values) {
      if (!metrics.contains(metric)) {
        ThrowError(where + ", jobs", "a value of " + metric, "one of the metrics named above it");
      }
    }
    values += job.values.size();
  }
  if (values == 0) ThrowError(where, "no value", "something to hold runs against");
}

}  // namespace

std::string BaselineJson(const Baseline& baseline) {
  const Json suite = baseline.suite;
  const Json build = {
      {"identity", baseline.build}, {"cpu_level", baseline.cpu_level}, {"commit", baseline.commit}};
  return StrCat("{\n \"schema_version\": ", kBaselineSchemaVersion,
                ",\n \"kind\": \"baseline\",\n \"suite\": ", suite.dump(),
                ",\n \"build\": ", build.dump(), ",\n \"seeds\": ", Json(baseline.seeds).dump(),
                ",\n \"metrics\": ", Lines(baseline.metrics),
                ",\n \"jobs\": ", Lines(baseline.jobs), "\n}\n");
}

Baseline ReadBaseline(const std::filesystem::path& file) {
  const Json json = ReadJson(file);
  const Fields fields(json, file.string());
  fields.Check(kBaselineSchemaVersion, "baseline");
  Baseline baseline;
  baseline.suite = fields.Text("suite");
  baseline.build = fields.Object("build").Text("identity");
  baseline.commit = fields.Object("build").Text("commit");
  baseline.cpu_level = fields.Object("build").TextOr("cpu_level", baseline.cpu_level);
  baseline.seeds = fields.Counts("seeds");
  for (const Json& metric : fields.Array("metrics")) {
    baseline.metrics.push_back(ReadMetric({metric, fields.where() + ", metrics"}));
  }
  for (const Json& job : fields.Array("jobs")) {
    baseline.jobs.push_back(ReadJob({job, fields.where() + ", jobs"}));
  }
  CheckJobs(baseline, fields.where());
  return baseline;
}

}  // namespace cvo::reports
