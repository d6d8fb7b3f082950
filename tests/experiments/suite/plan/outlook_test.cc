// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "experiments/suite/plan/plan_outlook.h"
#include "reports/results/timing.h"
#include "tests/experiments/suite/examples.h"
#include "tests/support/temp_folder.h"

namespace cvo {
namespace {

using testing::HasSubstr;

// A made-up plan with one job per variant, which needs no sequence.
Plan PlanOf(const std::vector<std::string>& variants) {
  Json json = test::FolderSuite("x");
  json["variants"] = variants;
  Plan plan;
  plan.suite = test::Parse(json);
  plan.build = "build";
  for (const Cell& cell : ExpandSuite(plan.suite)) {
    plan.jobs.push_back({cell, "/x", "", 70, "content", "input", "job of " + cell.variant});
  }
  return plan;
}

EarlierRuns With(const std::optional<Plan>& plan, const std::set<std::string>& done) {
  return {plan, [done](const PlannedJob& job) { return done.count(job.job) > 0; },
          [](const std::string&) { return std::string(); }};
}

TEST(PlanOutlook, CountsDoneNewAndMissingJobs) {
  Plan plan = PlanOf({"full", "static", "2d"});
  plan.jobs[2].missing = kNotRendered;
  const auto outlook = PredictStates(plan, With(std::nullopt, {"job of full"}));
  EXPECT_EQ(outlook[0].state, JobState::kDone);
  EXPECT_EQ(outlook[1].state, JobState::kRuns);
  EXPECT_EQ(outlook[1].why, "new");
  EXPECT_EQ(outlook[2].state, JobState::kPrepares);
  plan.jobs[2].missing = "no such drive";
  EXPECT_EQ(PredictStates(plan, With(std::nullopt, {}))[2].why, "no such drive");
}

TEST(PlanOutlook, ReportsWhyADoneJobRunsAgain) {
  const Plan earlier = PlanOf({"full"});
  const auto why = [&](Plan plan) {
    plan.jobs[0].job = "another";
    return PredictStates(plan, With(earlier, {"job of full"})).at(0).why;
  };
  Plan plan = earlier;
  plan.build = "other";
  EXPECT_EQ(why(plan), "different build of the program");
  plan.jobs[0].content = "changed";
  EXPECT_EQ(why(plan), "different build of the program, the sequence has changed");
  plan = earlier;
  plan.suite.options = {{"window", {{"spatial", 7}}}};
  EXPECT_EQ(why(plan), "different options");
  EXPECT_EQ(why(earlier), "different boxes or files");
}

TEST(PlanOutlook, ReportsPendingAndFailedJobs) {
  const Plan earlier = PlanOf({"full"});
  const Plan plan = PlanOf({"full", "static"});
  EarlierRuns runs = With(earlier, {});
  EXPECT_EQ(PredictStates(plan, runs)[0].why, "not run yet");
  EXPECT_EQ(PredictStates(plan, runs)[1].why, "not in the previous plan");
  runs.failed = [](const std::string& job) {
    return job == "job of full" ? std::string("no memory") : "";
  };
  EXPECT_EQ(PredictStates(plan, runs)[0].why, "failed before: no memory");
}

TEST(PlanOutlook, EstimatesFromMeasuredTimes) {
  const test::TempFolder folder;
  reports::TimingData timing;
  timing.wall_s = 7.0;
  timing.frames = Json::array({Json::object(), Json::object()});
  folder.Write("job of full/timing.json", FileText(timing));
  folder.Write("job of 2d/timing.json", "damaged");
  BuiltPlan built{PlanOf({"full", "static", "2d"}), {}};
  auto outlook = PredictStates(built.plan, With(std::nullopt, {}));
  EXPECT_DOUBLE_EQ(EstimatedSeconds(built, outlook, {}), 3 * 70 * kAssumedFrame_s);
  const EarlierRuns earlier = With(PlanOf({"no_pairwise"}), {"job of full", "job of 2d"});
  outlook = PredictStates(built.plan, earlier);
  const auto times_s = MeasuredFrameTimes(
      built.plan, earlier, [&](const std::string& job) { return folder.path() / job; });
  EXPECT_EQ(times_s, (std::map<std::string, double>{{"", 3.5}, {"full", 3.5}}));
  EXPECT_DOUBLE_EQ(EstimatedSeconds(built, outlook, times_s), 70 * 3.5);
  built.preparations = {{"a", "x", "/a", {}, 10, Stage::kDrawing},
                        {"b", "x", "/b", {}, 10, Stage::kNoise}};
  EXPECT_DOUBLE_EQ(EstimatedSeconds(built, outlook, times_s),
                   70 * 3.5 + 10 * kAssumedDrawnFrame_s + 20 * kAssumedNoisyFrame_s);
}

TEST(PlanOutlook, CountsAJobSharedByTwoCellsOnce) {
  BuiltPlan built{PlanOf({"full", "static"}), {}};
  built.plan.jobs[1].job = built.plan.jobs[0].job;
  const auto outlook = PredictStates(built.plan, With(std::nullopt, {}));
  EXPECT_DOUBLE_EQ(EstimatedSeconds(built, outlook, {}), 70 * kAssumedFrame_s);
}

}  // namespace
}  // namespace cvo
