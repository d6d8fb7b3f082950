// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/cli/suite/plan_state.h"

#include "core/base/error.h"
#include "experiments/jobs/job_status.h"

namespace cvo {
namespace {

namespace fs = std::filesystem;

std::optional<Plan> EarlierPlan(const SuiteFolder& folder) {
  try {
    if (fs::exists(folder.plan())) return ParsePlan(ReadJson(folder.plan()), folder.plan());
  } catch (const Error&) {
  }
  return std::nullopt;
}

std::string FailureOf(const fs::path& file) {
  try {
    if (fs::exists(file)) return ReadJson(file).at("message");
  } catch (const std::exception&) {
    return "reason not readable in " + file.string();
  }
  return "";
}

}  // namespace

PlanState FindPlanState(const Suite& suite, const PlanRequest& request, const SuiteFolder& folder) {
  PlanState state;
  state.built = BuildPlan(suite, request);
  const EarlierRuns earlier = {
      EarlierPlan(folder), [&](const PlannedJob& job) { return HasFiles(folder, job); },
      [&](const std::string& job) { return FailureOf(folder.failure(job)); }};
  state.outlook = PredictStates(state.built.plan, earlier);
  state.frame_times_s = MeasuredFrameTimes(state.built.plan, earlier,
                                           [&](const std::string& job) { return folder.job(job); });
  return state;
}

}  // namespace cvo
