// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <iostream>
#include <memory>

#include "core/base/error.h"
#include "core/files/json/json.h"
#include "experiments/cli/command.h"
#include "experiments/cli/output_place.h"
#include "experiments/cli/suite/job_report.h"
#include "experiments/jobs/run_plan.h"

namespace cvo {
namespace {

Json StatusToJson(const SuiteFolder& folder, const Plan& plan,
                  const std::vector<JobStatus>& status) {
  const PlanOutcome counts = CountJobs(status);
  Json jobs = Json::array();
  for (std::size_t i = 0; i < status.size(); ++i) {
    const PlannedJob& job = plan.jobs[i];
    jobs.push_back({{"job", job.job},
                    {"name", Describe(job.cell)},
                    {"state", ToString(status[i].state)},
                    {"message", status[i].message},
                    {"log", job.job.empty() ? "" : folder.log(job.job).string()}});
  }
  return {{"schema_version", 1},
          {"kind", "status"},
          {"suite", plan.suite.name},
          {"counts",
           {{"done", counts.done},
            {"failed", counts.failed},
            {"missing", counts.missing},
            {"no_sequence", counts.no_sequence}}},
          {"jobs", std::move(jobs)}};
}

int ShowStatus(const std::string& path, bool json) {
  CheckNoCollection(path);
  const SuiteFolder folder{path};
  if (!std::filesystem::exists(folder.plan())) {
    ThrowError(path, "no plan.json", "an output folder of clustervo experiment run");
  }
  const Plan plan = ParsePlan(ReadJson(folder.plan()), folder.plan().string());
  const std::vector<JobStatus> status = StatusOfAll(folder, plan);
  if (json) {
    std::cout << DumpJson(StatusToJson(folder, plan, status));
  } else {
    std::cout << plan.suite.name << ": ";
    PrintJobs(folder, plan, status, std::cout);
  }
  const PlanOutcome counts = CountJobs(status);
  return counts.failed + counts.missing == 0 ? 0 : kIncomplete;
}

}  // namespace

Command AddExperimentStatusCommand(CLI::App& experiment) {
  CLI::App* app = experiment.add_subcommand(
      "status", "Show which jobs of a suite folder are done, failed or missing, and why");
  const auto folder = std::make_shared<std::string>();
  const auto json = std::make_shared<bool>(false);
  app->add_option("DIR", *folder, "output folder of the suite")->type_name("")->required();
  app->add_flag("--json", *json, "print JSON, one entry per job");
  app->footer(
      "Read-only; can be used while the suite runs. Exit code 0: all jobs whose sequence is "
      "present\nare done, 1: some are not. clustervo experiment run runs failed and missing jobs "
      "again.");
  return {app, [folder, json] { return ShowStatus(*folder, *json); }};
}

}  // namespace cvo
