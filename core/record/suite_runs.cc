// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/record/suite_runs.h"

#include <algorithm>
#include <set>

namespace cvo::reports {
namespace {

namespace fs = std::filesystem;

std::string Joined(const std::vector<std::string>& texts) {
  std::string joined;
  for (const std::string& text : texts) joined += (joined.empty() ? "" : ",") + text;
  return joined;
}

std::string OrNone(const std::string& text) { return text.empty() ? "none" : text; }

PlannedRun Planned(const PlanJob& job) {
  PlannedRun run{job, {}};
  run.keys["sequence"] = job.sequence;
  run.keys["detections"] = OrNone(job.detections);
  run.keys["variant"] = job.system.empty() ? job.variant : job.system;
  run.keys["oracle"] = OrNone(Joined(job.oracle));
  for (const auto& [path, value] : job.parameters.items()) {
    run.keys[path] = value.is_string() ? value.get<std::string>() : value.dump();
  }
  return run;
}

void CheckSame(const RunSummary& run, const std::string& what, const std::string& found,
               const std::string& expected) {
  if (found != expected) {
    ThrowError(run.file.string(), StrCat("the result of ", what, " ", Quoted(found)),
               Quoted(expected) + ", as plan.json says");
  }
}

std::set<std::string> OraclesOf(const RunSummary& run) {
  const Json* oracle = internal::FindField(run.given, "oracle", run.file.string());
  if (oracle == nullptr) return {};
  const auto names = FromJson<std::vector<std::string>>(*oracle, run.file.string() + ", oracle");
  return {names.begin(), names.end()};
}

void ReadResult(const fs::path& file, const std::vector<std::string>& metrics, SuiteRun& run) {
  try {
    RunSummary summary = ReadRun(file, metrics);
    CheckRunOf(run.planned, summary);
    const fs::path times = file.parent_path() / "timing.json";
    if (std::find(metrics.begin(), metrics.end(), kFrameCpu) != metrics.end() &&
        fs::exists(times)) {
      const int frames = std::max(summary.sequence.frames, 1);
      const double cpu_ms = 1e3 * ReadRecord<TimingData>(times).cpu_s / frames;
      summary.metrics.push_back({kFrameCpu, cpu_ms, MetricUnit::kMs, frames, {}, {}});
    }
    run.state = summary.status;
    run.message = summary.message;
    if (run.state == "ok" || run.state == "lost") {
      run.run = std::move(summary);
      return;
    }
    if (run.message.empty()) run.message = "ended as " + run.state;
  } catch (const Error& error) {
    run.message = error.what();
  }
  run.state = "failed";
}

void ReadFailure(const fs::path& file, SuiteRun& run) {
  run.state = "failed";
  try {
    const auto failure = ReadRecord<JobFailure>(file);
    run.message = failure.message;
    run.log = failure.log;
  } catch (const Error& error) {
    run.message = error.what();
  }
}

}  // namespace

void PlanJob::Check(const std::string& where) const {
  if (job.empty() && missing.empty()) ThrowError(where, "no job and no reason why", "one of them");
  if (job.starts_with('.') || job.find('/') != std::string::npos) {
    ThrowError(where + ", field job", Quoted(job), "the name of its folder");
  }
}

void CheckRunOf(const PlanJob& job, const RunSummary& run) {
  CheckSame(run, "job", run.job, job.job);
  CheckSame(run, "variant", run.variant, job.ResultVariant());
  CheckSame(run, "seed", StrCat(run.seed), StrCat(job.seed));
  if (!job.content.empty()) CheckSame(run, "data", run.sequence.content, job.content);
  const std::map<std::string, std::string> options = FlatJson(run.options);
  for (const auto& [path, value] : job.parameters.items()) {
    const auto found = options.find(path);
    if (found == options.end()) continue;  // a parameter of the scene
    const Json is = ParseJson(found->second, run.file.string());
    if (is != value) CheckSame(run, path, is.dump(), value.dump());
  }
  if (OraclesOf(run) != std::set<std::string>(job.oracle.begin(), job.oracle.end())) {
    ThrowError(run.file.string(), "the result of other oracles", "those of plan.json");
  }
}

SuitePlan ReadPlan(const fs::path& plan_file) {
  if (!fs::exists(plan_file)) {
    ThrowError(plan_file.string(), "no such file", "the folder that a suite was run to");
  }
  const auto file = ReadRecord<PlanFile>(plan_file);
  SuitePlan plan{file.table, plan_file, file.suite.name, file.suite.about, {}};
  if (file.definition.contains("timed_threads")) {
    plan.metrics.insert(plan.metrics.begin(), kFrameCpu);
  }
  for (const PlanJob& job : file.jobs) plan.runs.push_back(Planned(job));
  if (plan.runs.empty())
    ThrowError(plan_file.string() + ", field jobs", "none", "at least one job");
  if (plan.rows.empty()) {
    ThrowError(plan_file.string() + ", table, field rows", "none", "at least one key");
  }
  return plan;
}

std::vector<SuiteRun> ReadRuns(const fs::path& folder, const SuitePlan& plan,
                               const std::vector<std::string>& metrics) {
  std::vector<SuiteRun> runs;
  for (const PlannedRun& planned : plan.runs) {
    SuiteRun run{planned, "not run", "", "", std::nullopt};
    const fs::path result = folder / "jobs" / planned.job / "result.json";
    const fs::path failure = folder / "failed" / (planned.job + ".json");
    if (planned.job.empty()) {
      run.message = planned.missing;
      if (planned.missing != kNotRendered) run.state = "no data";
    } else if (fs::exists(result)) {
      ReadResult(result, metrics, run);
    } else if (fs::exists(failure)) {
      ReadFailure(failure, run);
    }
    runs.push_back(std::move(run));
  }
  return runs;
}

std::string KeyOf(const PlannedRun& run, const std::string& key) {
  if (key == "family") return OrNone(run.family);
  const auto found = run.keys.find(key);
  return found == run.keys.end() ? "default" : found->second;
}

}  // namespace cvo::reports
