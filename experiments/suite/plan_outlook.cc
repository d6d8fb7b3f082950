// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/suite/plan_outlook.h"

#include <map>
#include <set>

#include "core/base/error.h"
#include "core/record/run_summary.h"

namespace cvo {
namespace {

constexpr int kFilesRead = 20;
constexpr double kAssumedFrame_s = 1.0 / 35.0;

// Identifies a job as the user sees it, regardless of what it is computed from.
std::string NameOf(const PlanJob& job) { return Describe(job) + "\n" + job.detections; }

std::string Differences(const Plan& plan, const PlanJob& job, const Plan& earlier,
                        const PlanJob& before) {
  std::string why;
  const auto add = [&why](bool differs, const char* what) {
    if (differs) why += (why.empty() ? "" : ", ") + std::string(what);
  };
  add(plan.build != earlier.build, "different build of the program");
  add(job.content != before.content, "the sequence has changed");
  add(job.system.empty() && plan.suite.options != earlier.suite.options, "different options");
  return why.empty() ? "different boxes or files" : why;
}

std::string ReasonToRun(const Plan& plan, const PlanJob& job, const EarlierRuns& earlier,
                        const std::map<std::string, const PlanJob*>& before) {
  if (const std::string message = earlier.failed(job.job); !message.empty()) {
    return "failed before: " + message;
  }
  const auto found = before.find(NameOf(job));
  if (found == before.end()) return earlier.plan ? "not in the previous plan" : "new";
  const PlanJob& same = *found->second;
  // A job that was never computed cannot be outdated.
  if (same.job == job.job || same.job.empty() || !earlier.done(same)) return "not run yet";
  return Differences(plan, job, *earlier.plan, same);
}

double PreparedFrame_s(Stage stage) {
  if (stage == Stage::kBoxes) return 0.2;
  return stage == Stage::kDrawing ? 0.28 : 0.03;
}

}  // namespace

std::vector<PredictedState> PredictStates(const Plan& plan, const EarlierRuns& earlier) {
  std::map<std::string, const PlanJob*> before;
  if (earlier.plan) {
    for (const PlanJob& job : earlier.plan->jobs) before.emplace(NameOf(job), &job);
  }
  std::vector<PredictedState> outlook;
  for (const PlanJob& job : plan.jobs) {
    if (!job.missing.empty()) {
      const bool pending = IsPending(job.missing);
      outlook.push_back({pending ? JobState::kPrepares : JobState::kMissing, job.missing});
    } else if (earlier.done(job)) {
      outlook.push_back({JobState::kDone, ""});
    } else {
      outlook.push_back({JobState::kRuns, ReasonToRun(plan, job, earlier, before)});
    }
  }
  return outlook;
}

std::optional<double> MeasuredFrameTime_s(
    const Plan& plan, const EarlierRuns& earlier,
    const std::function<std::filesystem::path(const std::string& job)>& folder_of) {
  double sum_s = 0.0;
  int files = 0;
  const auto measure = [&](const PlanJob& job) {
    if (files == kFilesRead || job.job.empty() || job.variant.empty() || !earlier.done(job)) return;
    try {
      const auto timing = ReadRecord<reports::TimingData>(folder_of(job.job) / "timing.json");
      if (timing.frames.empty()) return;
      sum_s += timing.wall_s / static_cast<double>(timing.frames.size());
      ++files;
    } catch (const Error&) {  // the estimate can do without it
    }
  };
  for (const PlanJob& job : plan.jobs) measure(job);
  if (earlier.plan) {
    for (const PlanJob& job : earlier.plan->jobs) measure(job);
  }
  return files > 0 ? std::optional(sum_s / files) : std::nullopt;
}

double EstimatedSeconds(const BuiltPlan& built, const std::vector<PredictedState>& outlook,
                        const std::optional<double>& frame_time_s) {
  double seconds = 0.0;
  for (const Preparation& preparation : built.preparations) {
    seconds += preparation.frames * PreparedFrame_s(preparation.stage);
  }
  std::set<std::string> counted;
  for (std::size_t i = 0; i < built.plan.jobs.size(); ++i) {
    const PlanJob& job = built.plan.jobs[i];
    const JobState state = outlook.at(i).state;
    if (state == JobState::kDone || state == JobState::kMissing || !job.system.empty()) continue;
    if (!job.job.empty() && !counted.insert(job.job).second) continue;
    seconds += job.frames * frame_time_s.value_or(kAssumedFrame_s);
  }
  return seconds;
}

}  // namespace cvo
