// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/results/suite_runs.h"

#include "core/files/json_fields.h"

namespace cvo::reports {
namespace {

namespace fs = std::filesystem;

constexpr int kPlanSchemaVersion = 1;
constexpr int kFailureSchemaVersion = 1;
constexpr char kNotRendered[] = "not rendered yet";  // PlannedJob::missing of a scene to be drawn

std::string Joined(const std::vector<std::string>& texts) {
  std::string joined;
  for (const std::string& text : texts) joined += (joined.empty() ? "" : ",") + text;
  return joined;
}

std::string OrNone(const std::string& text) { return text.empty() ? "none" : text; }

PlannedRun ReadPlanned(const Fields& fields) {
  PlannedRun run;
  const std::string system = fields.TextOr("system", "");
  run.system = !system.empty();
  run.keys["sequence"] = fields.Text("sequence");
  run.keys["detections"] = OrNone(fields.TextOr("detections", ""));
  run.keys["variant"] = run.system ? system : fields.Text("variant");
  run.keys["oracle"] = OrNone(fields.Has("oracle") ? Joined(fields.Texts("oracle")) : "");
  if (fields.Has("parameters")) {
    const Fields parameters = fields.Object("parameters");
    for (const auto& [path, value] : parameters.json().items()) {
      run.keys[path] = value.is_string() ? value.get<std::string>() : value.dump();
    }
  }
  run.seed = fields.Count("seed");
  run.job = fields.TextOr("job", "");
  run.missing = fields.TextOr("missing", "");
  return run;
}

void ReadResult(const fs::path& file, const std::vector<std::string>& metrics, SuiteRun& run) {
  try {
    RunSummary summary = ReadRun(file, metrics);
    if (summary.job != run.planned.job) {
      ThrowError(file.string(), "the result of job " + summary.job, "that of its folder's name");
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
    const Json json = ReadJson(file);
    const Fields fields(json, file.string());
    fields.CheckSchema(kFailureSchemaVersion);
    run.message = fields.Text("message");
    run.log = fields.TextOr("log", "");
  } catch (const Error& error) {
    run.message = error.what();
  }
}

}  // namespace

SuitePlan ReadPlan(const fs::path& plan_file) {
  if (!fs::exists(plan_file)) {
    ThrowError(plan_file.string(), "no such file", "the folder that a suite was run to");
  }
  const Json json = ReadJson(plan_file);
  const Fields fields(json, plan_file.string());
  fields.Check(kPlanSchemaVersion, "plan");
  SuitePlan plan;
  plan.file = plan_file;
  plan.name = fields.Object("suite").Text("name");
  plan.about = fields.Object("suite").TextOr("about", "");
  const Fields table = fields.Object("table");
  plan.rows = table.Texts("rows");
  plan.metrics = table.Texts("metrics");
  plan.reference = table.TextOr("reference", "");
  for (const Json& job : fields.Array("jobs")) {
    plan.runs.push_back(ReadPlanned({job, fields.where() + ", jobs"}));
  }
  if (plan.runs.empty()) ThrowError(fields.where() + ", field jobs", "none", "at least one job");
  if (plan.rows.empty()) ThrowError(table.where() + ", field rows", "none", "at least one key");
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
  const auto found = run.keys.find(key);
  return found == run.keys.end() ? "default" : found->second;
}

}  // namespace cvo::reports
