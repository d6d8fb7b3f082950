// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/suite/run_plan.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/mount.h>
#include <sys/stat.h>

#include <cerrno>
#include <cstring>
#include <fstream>

#include "core/base/error.h"
#include "core/files/text_file.h"
#include "experiments/suite/engine.h"
#include "tests/support/error_message.h"
#include "tests/support/temp_folder.h"

namespace cvo::run_plan_test {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

// Tests RunPlan on hand-made plans, with a shell script in place of the program.

std::string ResultText(const std::string& id, const std::string& status = "ok") {
  return StrCat(R"({"schema_version": 3, "kind": "run", "job": ")", id, R"(", "status": ")", status,
                R"(", "variant": "full", "seed": 0, "sequence": {"name": "s", "type": "t",)",
                R"( "pair": "grey", "first_frame": 0, "frames": 2, "total_frames": 2}})");
}

// Runs scripts/JOB if it exists, then writes the result of JOB unless that script has exited.
const std::string kProgram = StrCat(R"(#!/bin/sh
[ "$1 $2" = "experiment job" ] || exit 9
cd "$3" || exit 9
echo "$4" >> order
mkdir -p "jobs/$4"
[ -e "scripts/$4" ] && . "scripts/$4"
sed "s/JOB/$4/" > "jobs/$4/result.json" << END
)",
                                    ResultText("JOB"), "\nEND\n");

class RunPlanTest : public testing::Test {
 protected:
  RunPlanTest() {
    run_.folder.root = out();
    run_.program = folder_.Write("program", kProgram).string();
    ::chmod(run_.program.c_str(), 0755);
    fs::create_directory(out());
  }

  fs::path out() const { return folder_.path() / "out"; }
  void Script(const std::string& id, const std::string& script) const {
    folder_.Write(fs::path("out/scripts") / id, script + "\n");
  }
  static PlanJob Job(const std::string& id, const std::string& input) {
    PlanJob job;
    job.job = id;
    job.input = input;
    job.folder = "/sequence";
    job.variant = "full";
    return job;
  }
  static Plan PlanOf(const std::vector<PlanJob>& jobs) {
    Plan plan;
    plan.suite.sequences.resize(1);
    plan.jobs = jobs;
    return plan;
  }
  PlanOutcome Run(const Plan& plan, int processes = 1) {
    LocalEngine engine(processes);
    return RunPlan(plan, run_, engine);
  }
  // Returns the jobs started since the last call, in order of their start.
  std::vector<std::string> Started() const {
    std::vector<std::string> ids;
    if (!fs::exists(out() / "order")) return ids;
    const TextFile file(out() / "order");
    for (std::size_t i = 0; i < file.size(); ++i) ids.push_back(file.line(i));
    fs::remove(out() / "order");
    return ids;
  }
  Json Failure(const std::string& id) const { return ReadJson(run_.folder.failure(id)); }

  test::TempFolder folder_;
  PlanRun run_;
  const Plan plan_ = PlanOf({Job("a1", "a"), Job("a2", "a"), Job("b1", "b"), Job("a2", "a")});
};

TEST_F(RunPlanTest, StartsOneJobPerInputFirstAndNoJobTwice) {
  std::vector<std::pair<std::size_t, std::size_t>> seen;
  run_.progress = [&](std::size_t ended, std::size_t total) { seen.emplace_back(ended, total); };
  const PlanOutcome outcome = Run(plan_);
  using P = std::pair<std::size_t, std::size_t>;
  EXPECT_THAT(seen, ElementsAre(P(0, 3), P(1, 3), P(2, 3), P(3, 3)));
  EXPECT_THAT(Started(), ElementsAre("a1", "b1", "a2"));
  EXPECT_EQ(outcome.done, 4U);
  EXPECT_EQ(outcome.failed + outcome.missing, 0U);
  EXPECT_FALSE(outcome.stopped);
  Run(plan_);
  EXPECT_THAT(Started(), IsEmpty());
}

TEST_F(RunPlanTest, AFailureAffectsOneJobAndIsRetried) {
  Script("a1", "echo 'clustervo: error: no such thing' >&2; exit 1");
  Script("b1", "echo on the way; kill -SEGV $$");
  Script("a2", "exit 0");
  EXPECT_EQ(Run(plan_).failed, 4U);  // two of them of job a2
  EXPECT_EQ(Failure("a2")["message"], "ended without a result");
  EXPECT_EQ(Failure("a1")["message"], "no such thing");
  EXPECT_EQ(Failure("a1")["job"], "a1");
  EXPECT_EQ(Failure("b1")["message"], "killed by signal 11 (SIGSEGV)");
  EXPECT_EQ(Failure("b1")["log"], "on the way\n");
  Started();

  Script("a1", ":");
  Script("a2", ":");
  const PlanOutcome second = Run(plan_);
  EXPECT_THAT(Started(), ElementsAre("a1", "b1", "a2"));
  EXPECT_EQ(second.done, 3U);
  EXPECT_FALSE(fs::exists(run_.folder.failure("a1")));
  EXPECT_EQ(StatusOf(run_.folder, plan_.jobs[2]).message, "killed by signal 11 (SIGSEGV)");
}

TEST_F(RunPlanTest, AResultWithoutRequestedLandmarksIsNotDone) {
  Plan plan = plan_;
  plan.jobs[0].landmarks = true;
  EXPECT_EQ(Run(plan_).done, 4U);
  EXPECT_EQ(StatusOf(run_.folder, plan.jobs[0]).state, JobStatus::State::kMissing);
  std::ofstream(run_.folder.job("a1") / "landmarks.csv") << "frame\n";
  EXPECT_EQ(StatusOf(run_.folder, plan.jobs[0]).state, JobStatus::State::kDone);
}

TEST_F(RunPlanTest, OnlyACompleteResultOfThisJobCounts) {
  const std::vector<std::string> bad = {
      "",                              // truncated
      ResultText("a1").substr(0, 40),  // cut in half
      ResultText("b1"),                // of another job
      ResultText("a1", "failed"),      // the estimator gave up
      "[1]",                           // something else
      // Results that no table could read:
      ResultText("a1").replace(ResultText("a1").find("\"frames\": 2"), 11, "\"frames\": nan"),
      ResultText("a1").replace(ResultText("a1").find("\"seed\""), 6, "\"se\""),
      "{\"schema_version\": 1, \"kind\": \"run\", \"job\": \"a1\", \"status\": \"ok\"}"};
  for (const std::string& text : bad) {
    Run(plan_);
    Started();
    folder_.Write("out/jobs/a1/result.json", text);
    EXPECT_EQ(StatusOf(run_.folder, plan_.jobs[0]).state, JobStatus::State::kMissing) << text;
    EXPECT_EQ(Run(plan_).done, 4U) << text;
    EXPECT_THAT(Started(), ElementsAre("a1")) << text;
  }
}

TEST_F(RunPlanTest, AJobWithoutASequenceDoesNotRun) {
  Plan plan = plan_;
  plan.jobs[2].job.clear();
  plan.jobs[2].folder.clear();
  plan.jobs[2].missing = "no such folder";
  const PlanOutcome outcome = Run(plan);
  EXPECT_EQ(outcome.no_sequence, 1U);
  EXPECT_EQ(outcome.done, 3U);
  EXPECT_EQ(StatusOfAll(run_.folder, plan)[2].message, "no such folder");

  plan.jobs[2].folder = "/found/and/damaged";
  EXPECT_EQ(Run(plan).failed, 1U);
  plan.jobs[2].folder.clear();
  plan.suite.sequences[0].scene = "tiny";  // a scene can always be rendered
  EXPECT_EQ(Run(plan).failed, 1U);
  plan.jobs[2].missing = kNotRendered;
  EXPECT_EQ(Run(plan).missing, 1U);
}

TEST_F(RunPlanTest, ResultsOfAnotherPlanAreKeptAndReused) {
  Run(plan_);
  Started();
  const Plan edited = PlanOf({Job("a1", "a"), Job("c1", "c")});
  EXPECT_EQ(Run(edited).done, 2U);
  EXPECT_THAT(Started(), ElementsAre("c1"));
  Run(plan_);
  EXPECT_THAT(Started(), IsEmpty());
}

TEST_F(RunPlanTest, StopKeepsResultsAndReportsTheRest) {
  Script("b1", "sleep 60");
  run_.stop = [&] { return fs::exists(run_.folder.log("b1")); };
  PlanOutcome outcome = Run(plan_);
  EXPECT_TRUE(outcome.stopped);
  EXPECT_EQ(outcome.done, 1U);
  EXPECT_EQ(outcome.missing, 3U);  // two of them of job a2
  EXPECT_FALSE(fs::exists(run_.folder.failure("b1")));
  EXPECT_THAT(Started(), ElementsAre("a1", "b1"));
}

TEST_F(RunPlanTest, AnUnwritableFailureRecordEndsTheRun) {
  Script("a1", "exit 1");
  fs::create_directories(run_.folder.failure("a1") / "in the way");
  EXPECT_THAT(ErrorMessage([&] { Run(plan_); }), HasSubstr("a1.json: cannot write"));
  EXPECT_THAT(Started(), ElementsAre("a1"));
  fs::remove_all(run_.folder.failure("a1"));
  EXPECT_EQ(Run(plan_).done, 3U);
}

TEST_F(RunPlanTest, PreparationsReportFailures) {
  const auto task = [&](const std::string& name, const std::string& script) {
    return Task{.name = name, .argv = {"/bin/sh", "-c", script}, .log = run_.folder.log(name)};
  };
  LocalEngine engine(1);
  const std::vector<Task> tasks = {task("good", "true"),
                                   task("bad", "echo clustervo: error: no paint; exit 1")};
  EXPECT_THAT(RunPreparations(tasks, run_, engine).value(), ElementsAre("", "no paint"));
  run_.stop = [] { return true; };
  EXPECT_FALSE(RunPreparations(tasks, run_, engine).has_value());
}

}  // namespace
}  // namespace cvo::run_plan_test
