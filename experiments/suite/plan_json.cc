// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/error.h"
#include "experiments/suite/parse_suite.h"
#include "experiments/suite/plan.h"

namespace cvo {
namespace {

constexpr int kSchemaVersion = 1;
constexpr char kKind[] = "plan";

// Which of the suite's sequences it is.
std::size_t EntryOf(const SuiteSequence& sequence, const Suite& suite) {
  for (std::size_t i = 0; i < suite.sequences.size(); ++i) {
    const SuiteSequence& other = suite.sequences[i];
    if (other.name == sequence.name && other.detections == sequence.detections) return i;
  }
  ThrowError("plan", "a job on " + sequence.name, "a sequence of the suite");
}

Json JobToJson(const PlannedJob& job, const Suite& suite) {
  const Cell& cell = job.cell;
  Json parameters = Json::object();
  for (const auto& [path, value] : cell.parameters) parameters[path] = value;
  return {{"sequence", cell.sequence.name},
          {"detections", cell.sequence.detections},
          {"variant", cell.variant},
          {"system", cell.system},
          {"seed", cell.seed},
          {"oracle", cell.oracle},
          {"parameters", std::move(parameters)},
          {"landmarks", cell.landmarks},
          {"folder", job.folder},
          {"missing", job.missing},
          {"frames", job.frames},
          {"content", job.content},
          {"input", job.input},
          {"job", job.job},
          {"entry", EntryOf(cell.sequence, suite)}};
}

PlannedJob ParseJob(const Json& json, const Suite& suite) {
  PlannedJob job;
  job.cell.sequence = suite.sequences.at(json.at("entry").get<std::size_t>());
  job.cell.variant = json.at("variant");
  job.cell.system = json.at("system");
  job.cell.seed = json.at("seed");
  job.cell.oracle = json.at("oracle").get<std::vector<std::string>>();
  for (const auto& [path, value] : json.at("parameters").items()) {
    job.cell.parameters.emplace_back(path, value);
  }
  job.cell.landmarks = json.at("landmarks");
  job.folder = json.at("folder");
  job.missing = json.at("missing");
  job.frames = json.at("frames");
  job.content = json.at("content");
  job.input = json.at("input");
  job.job = json.at("job");
  return job;
}

}  // namespace

Json PlanToJson(const Plan& plan) {
  Json jobs = Json::array();
  for (const PlannedJob& job : plan.jobs) jobs.push_back(JobToJson(job, plan.suite));
  return {
      {"schema_version", kSchemaVersion},
      {"kind", kKind},
      {"suite",
       {{"name", plan.suite.name}, {"about", plan.suite.about}, {"split", SplitOf(plan.suite)}}},
      {"build", plan.build},
      {"data", plan.data},
      {"table",
       {{"rows", plan.suite.table.rows},
        {"metrics", plan.suite.table.metrics},
        {"reference", plan.suite.table.reference}}},
      {"definition", SuiteToJson(plan.suite)},
      {"jobs", std::move(jobs)}};
}

Plan ParsePlan(const Json& json, const std::string& where) {
  const std::string expected = StrCat("a \"", kKind, "\" of schema version ", kSchemaVersion);
  try {
    if (json.at("kind") != kKind || json.at("schema_version") != kSchemaVersion) {
      ThrowError(where, "another JSON file", expected);
    }
    Plan plan;
    plan.suite = ReadCheckedSuite(json.at("definition"), where + ", definition");
    plan.build = json.at("build");
    plan.data = json.at("data");
    for (const Json& job : json.at("jobs")) plan.jobs.push_back(ParseJob(job, plan.suite));
    return plan;
  } catch (const nlohmann::json::exception& error) {
    ThrowError(where, StrCat("a damaged one (", error.what(), ")"), expected);
  } catch (const std::out_of_range&) {
    ThrowError(where, "a job on a sequence that the suite does not have", expected);
  }
}

}  // namespace cvo
