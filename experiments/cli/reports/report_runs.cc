// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/cli/reports/report_runs.h"

#include <algorithm>
#include <array>
#include <set>

#include "core/base/error.h"
#include "core/files/atomic_file.h"
#include "core/files/json/json_record.h"
#include "core/files/text/unique_names.h"
#include "reports/results/metric_catalogue.h"
#include "reports/results/plan_file.h"
#include "reports/results/run_summary.h"

namespace cvo {
namespace {

namespace fs = std::filesystem;

// Metrics of the table, if any of the runs has them.
constexpr std::array<const char*, 8> kTableMetrics = {
    "camera_ate",      "camera_trpe_1_frame", "object_ate",       "object_success_10cm",
    "object_coverage", "object_id_switches",  "moving_precision", "moving_recall"};

std::vector<reports::RunSummary> ReadAll(const std::vector<std::string>& folders) {
  std::vector<reports::RunSummary> runs;
  for (const std::string& folder : folders) {
    const fs::path file = fs::path(folder) / "result.json";
    if (!fs::exists(file)) {
      ThrowError(folder, "no result.json", "the output folder of a run, as the others");
    }
    runs.push_back(reports::ReadRun(file, reports::AllMetricNames()));
    const std::string& sequence = runs.back().sequence.name;
    if (sequence != runs.front().sequence.name) {
      ThrowError(folder, "a run of " + sequence, "one of " + runs.front().sequence.name);
    }
  }
  return runs;
}

std::vector<std::string> MetricsOf(const std::vector<reports::RunSummary>& runs) {
  std::vector<std::string> metrics;
  for (const char* name : kTableMetrics) {
    const bool any = std::any_of(runs.begin(), runs.end(), [&](const auto& run) {
      return reports::FindMetric(run, name) != nullptr;
    });
    if (any) metrics.emplace_back(name);
  }
  return metrics;
}

reports::PlanJob JobOf(const reports::RunSummary& run) {
  reports::PlanJob job;
  job.sequence = run.sequence.name;
  job.variant = run.variant;
  if (run.system) {
    job.system = run.variant.substr(reports::SystemVariant("").size());
    job.variant.clear();
  }
  job.seed = run.seed;
  job.oracle = run.given.value("oracle", std::vector<std::string>());
  job.frames = run.sequence.frames;
  job.job = run.job;
  return job;
}

}  // namespace

void MakeSuiteOfRuns(const std::vector<std::string>& folders, const fs::path& folder) {
  const std::vector<reports::RunSummary> runs = ReadAll(folders);
  std::vector<std::string> variants;
  for (const reports::RunSummary& run : runs) variants.push_back(run.variant);
  const std::vector<std::string> names = UniqueNames(variants, folders);
  reports::PlanFile plan;
  plan.suite.name = "Runs on " + runs.front().sequence.name;
  plan.build = runs.front().build.identity;
  plan.table.metrics = MetricsOf(runs);
  plan.table.reference = names.front();
  if (names != variants) {
    plan.table.rows = {"variant", "run"};
    plan.table.reference = "run=" + names.front();
  }
  fs::create_directories(folder / "jobs");
  std::set<std::string> jobs;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (!jobs.insert(runs[i].job).second) ThrowError(folders[i], "the same run twice", "each once");
    plan.jobs.push_back(JobOf(runs[i]));
    if (names != variants) plan.jobs.back().parameters["run"] = names[i];
    fs::create_directory_symlink(fs::absolute(folders[i]), folder / "jobs" / runs[i].job);
  }
  WriteFilesAtomically(folder, {{"plan.json", FileText(plan)}});
}

}  // namespace cvo
