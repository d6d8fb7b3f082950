// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "reports/gate/check_runs.h"
#include "reports/gate/gate_text.h"
#include "reports/gate/make_baseline.h"
#include "tests/reports/gate/gate_folder.h"
#include "tests/support/error_message.h"

namespace cvo::reports {
namespace {

using test::GateFolder;
using test::Json;
using ::testing::AllOf;
using ::testing::Contains;
using ::testing::Field;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class GateTest : public ::testing::Test {
 protected:
  GateReport Check() const { return CheckRuns(now_.path(), MakeBaseline(then_.path())); }
  // Scales the ATE of every run of the scene and variant.
  void Scale(const std::string& scene, const std::string& variant, double factor) const {
    now_.ForEachJob([&](const std::string& s, const std::string& v, int seed) {
      if (s != scene || v != variant) return;
      now_.EditMetric(GateFolder::Id(s, v, seed), 1, factor * GateFolder::Ate(s, seed));
    });
  }
  static auto Problem(const std::string& where, const std::string& message) {
    return Contains(AllOf(Field(&GateProblem::where, HasSubstr(where)),
                          Field(&GateProblem::message, HasSubstr(message))));
  }

  GateFolder then_;
  GateFolder now_;
};

TEST_F(GateTest, SameResultsPass) {
  const GateReport report = Check();
  EXPECT_FALSE(report.Regressed());
  EXPECT_EQ(report.runs, 16U);
  // Two variants and two metrics, over both scenes together and on each of them.
  EXPECT_EQ(report.Count(Verdict::kSame), 12U);
  EXPECT_EQ(report.comparisons.size(), 12U);
  EXPECT_THAT(MovedRows(report), IsEmpty());
  EXPECT_THAT(NoteLines(report), IsEmpty());
}

TEST_F(GateTest, SceneThatGetsWorseIsFound) {
  Scale("room", "full", 2.0);
  const GateReport report = Check();
  EXPECT_TRUE(report.Regressed());
  EXPECT_THAT(report.problems, IsEmpty());
  ASSERT_EQ(report.Count(Verdict::kWorse), 1U);
  const TextRows rows = MovedRows(report);
  ASSERT_GE(rows.size(), 2U);
  EXPECT_EQ(rows[1][0], "full");
  EXPECT_EQ(rows[1][1], "room");
  EXPECT_EQ(rows[1][2], "camera_ate (m)");
  EXPECT_EQ(rows[1][3], "0.0125");
  EXPECT_EQ(rows[1][4], "0.025");
  EXPECT_EQ(rows[1][5], "+0.0125");
  EXPECT_EQ(rows[1].back(), "WORSE");
  EXPECT_THAT(GateText(report), HasSubstr("1 worse, 0 better"));
}

TEST_F(GateTest, ReportsWhichSubstitutedVariantsItWouldNotice) {
  const auto verdicts = [&] {
    return PowerText(CheckInPlaceOf("full", now_.path(), MakeBaseline(then_.path())));
  };
  EXPECT_THAT(verdicts(),
              AllOf(HasSubstr("full     NOT NOTICED"), HasSubstr("static   NOT NOTICED")))
      << "both have the same errors";
  Scale("room", "static", 2.0);
  EXPECT_THAT(verdicts(), AllOf(HasSubstr("full     NOT NOTICED"),
                                HasSubstr("static   noticed      2 of 6             ")));
  EXPECT_THAT(ErrorMessage([&] { CheckInPlaceOf("2d", now_.path(), MakeBaseline(then_.path())); }),
              HasSubstr("variant \"2d\": found no run of it in the baseline"));
}

TEST_F(GateTest, ChangesWithinSeedNoiseAreTolerated) {
  Scale("room", "full", 1.02);
  Scale("street", "static", 0.99);
  const GateReport report = Check();
  EXPECT_FALSE(report.Regressed());
  // Two changes, each on its scene and over both scenes.
  EXPECT_EQ(report.Count(Verdict::kWithin), 4U);
  EXPECT_EQ(MovedRows(report).size(), 3U) << "header, and the two over both scenes";
}

TEST_F(GateTest, ExactCheckFailsIfAnythingDiffersOnTheSamePlatform) {
  const auto run_with = [](const GateFolder& folder, const char* compiler) {
    folder.ForEachJob([&](const std::string& scene, const std::string& variant, int seed) {
      folder.Edit(GateFolder::Id(scene, variant, seed), [&](Json& result) {
        result["build"]["compiler"] = compiler;
        result["build"]["cpu_level"] = "avx2";
      });
    });
  };
  const auto check = [&] { return CheckRuns(now_.path(), MakeBaseline(then_.path()), true); };
  EXPECT_THAT(NoteLines(check()), Contains(HasSubstr("exactness is not checked")))
      << "neither says what made it";
  run_with(then_, "GNU 12");
  run_with(now_, "GNU 12");
  EXPECT_FALSE(check().Failed());
  EXPECT_THAT(NoteLines(check()), IsEmpty());
  Scale("room", "full", 0.999999);
  EXPECT_FALSE(Check().Failed());
  const GateReport changed = check();
  EXPECT_TRUE(changed.Failed());
  EXPECT_FALSE(changed.Regressed());
  EXPECT_EQ(changed.changed, 2U) << "on its scene and over both";
  EXPECT_THAT(GateText(changed), HasSubstr("2 of 12 values differ from the baseline"));
  EXPECT_THAT(GateMarkdown(changed), testing::StartsWith("### Changed\n"));
  EXPECT_THAT(GateJunit(changed), HasSubstr("failures=\"1\""));
  const Baseline baseline = MakeBaseline(then_.path());
  const auto parts = CheckInPlaceOf("full", now_.path(), baseline, true);
  EXPECT_THAT(PowerText(parts), HasSubstr("full     noticed      2 of 6"));
  run_with(now_, "GNU 14");
  EXPECT_FALSE(check().Failed());
  EXPECT_THAT(NoteLines(check()), Contains(AllOf(HasSubstr("exactness is not checked"),
                                                 HasSubstr("GNU 14"), HasSubstr("GNU 12"))));
}

TEST_F(GateTest, LowerCoverageIsWorseAndHigherIsNot) {
  now_.ForEachJob([&](const std::string& scene, const std::string& variant, int seed) {
    if (variant == "static") now_.EditMetric(GateFolder::Id(scene, variant, seed), 0, 0.9);
  });
  EXPECT_TRUE(Check().Regressed());
  EXPECT_EQ(Check().Count(Verdict::kWorse), 3U);
  const GateReport back = CheckRuns(then_.path(), MakeBaseline(now_.path()));
  EXPECT_FALSE(back.Regressed());
  EXPECT_EQ(back.Count(Verdict::kBetter), 3U);
  EXPECT_THAT(NoteLines(back), Contains(HasSubstr("update the baseline to hold this level")));
}

TEST_F(GateTest, MissingMetricFails) {
  now_.Edit(GateFolder::Id("room", "full", 2), [](Json& result) { result["metrics"].erase(1); });
  const GateReport report = Check();
  EXPECT_TRUE(report.Regressed());
  EXPECT_THAT(report.problems, Problem("full on room, detections good, seed 2", "no camera_ate"));
}

TEST_F(GateTest, MissingJobFails) {
  now_.EditPlan([](Json& plan) { plan["jobs"].erase(0); });
  EXPECT_THAT(Check().problems, Problem("full on room", "not among the jobs"));
}

TEST_F(GateTest, JobThatDidNotRunFails) {
  std::filesystem::remove_all(now_.path() / "jobs" / GateFolder::Id("street", "full", 1));
  const GateReport report = Check();
  EXPECT_THAT(report.problems, Problem("full on street", "not run"));
  EXPECT_TRUE(report.Regressed());
}

TEST_F(GateTest, FailedJobFailsWithItsMessage) {
  const std::string id = GateFolder::Id("street", "full", 1);
  std::filesystem::remove_all(now_.path() / "jobs" / id);
  now_.Write("failed/" + id + ".json", Json{{"schema_version", 1},
                                            {"kind", "failure"},
                                            {"job", id},
                                            {"message", "killed by signal 9"},
                                            {"log", ""}}
                                           .dump());
  EXPECT_THAT(Check().problems, Problem("full on street", "failed: killed by signal 9"));
}

TEST_F(GateTest, LostRunFails) {
  now_.Edit(GateFolder::Id("room", "full", 1), [](Json& result) { result["status"] = "lost"; });
  EXPECT_THAT(Check().problems, Problem("full on room", "ended as lost"));
}

TEST_F(GateTest, OtherCpuLevelIsNoted) {
  const auto run_on = [](const GateFolder& folder, const char* level) {
    folder.ForEachJob([&](const std::string& scene, const std::string& variant, int seed) {
      folder.Edit(GateFolder::Id(scene, variant, seed),
                  [&](Json& result) { result["build"]["cpu_level"] = level; });
    });
  };
  run_on(now_, "plain aarch64");
  EXPECT_THAT(NoteLines(Check()), testing::Contains(HasSubstr("(avx2, plain aarch64)")))
      << "a baseline that does not say was made with AVX2";
  run_on(then_, "plain aarch64");
  const GateReport same = Check();
  EXPECT_FALSE(same.Regressed());
  EXPECT_THAT(NoteLines(same), IsEmpty());
}

TEST_F(GateTest, AFolderWithoutResultsFails) {
  const Baseline baseline = MakeBaseline(then_.path());
  std::filesystem::remove_all(now_.path() / "jobs");
  const GateReport report = CheckRuns(now_.path(), baseline);
  EXPECT_THAT(report.problems, Problem("gate", "nothing was compared"));
  EXPECT_EQ(report.runs, 0U);
  test::TempFolder empty;
  EXPECT_THAT(ErrorMessage([&] { CheckRuns(empty.path(), baseline); }), HasSubstr("no such file"));
}

TEST_F(GateTest, AnotherContractFailsOnceAndIsNotCompared) {
  now_.ForEachJob([&](const std::string& scene, const std::string& variant, int seed) {
    now_.Edit(GateFolder::Id(scene, variant, seed), [](Json& result) {
      result["metrics"][1]["contract"]["alignment"] = "none";
      result["metrics"][1]["left_out"] = "7 frames";
    });
  });
  const GateReport report = Check();
  ASSERT_EQ(report.problems.size(), 1U);
  EXPECT_THAT(report.problems,
              Problem("camera_ate", "alignment \"none\", in the baseline \"SE(3)"));
  EXPECT_EQ(report.comparisons.size(), 6U) << "the coverage still is";
}

TEST_F(GateTest, AnotherUnitFails) {
  now_.Edit(GateFolder::Id("room", "full", 1),
            [](Json& result) { result["metrics"][1]["unit"] = "rad"; });
  EXPECT_THAT(Check().problems, Problem("camera_ate", "in rad, in the baseline in m"));
}

TEST_F(GateTest, OtherImagesAreNoted) {
  now_.Edit(GateFolder::Id("room", "full", 1),
            [](Json& result) { result["sequence"]["content"] = "other"; });
  EXPECT_THAT(NoteLines(Check()), Contains(HasSubstr("1 runs read other images")));
}

TEST_F(GateTest, AnotherNumberOfFramesFailsAndIsNotCompared) {
  now_.Edit(GateFolder::Id("room", "full", 1),
            [](Json& result) { result["sequence"]["frames"] = 10; });
  const GateReport report = Check();
  EXPECT_THAT(report.problems,
              Problem("full on room, detections good, seed 1", "10 frames, in the baseline 60"));
  EXPECT_EQ(report.runs, 15U);
}

TEST(Gate, SeedsBeyondThoseOfTheGateNeedNotRun) {
  const GateFolder then(8);
  const GateFolder now(2);
  const GateReport report = CheckRuns(now.path(), MakeBaseline(then.path(), 2));
  EXPECT_FALSE(report.Regressed());
  EXPECT_EQ(report.runs, 8U);
  EXPECT_TRUE(CheckRuns(now.path(), MakeBaseline(then.path())).Regressed());
}

TEST_F(GateTest, TimeIsRelativeToStatic) {
  // On a computer that is half as fast.
  now_.ForEachJob([&](const std::string& scene, const std::string& variant, int seed) {
    now_.WriteTime(GateFolder::Id(scene, variant, seed), variant == "static" ? 20.0 : 60.0);
  });
  EXPECT_FALSE(Check().Slower());
  ASSERT_EQ(Check().times.size(), 1U);
  EXPECT_NEAR(Check().times[0].baseline, 3.0, 1e-12);
  now_.ForEachJob([&](const std::string& scene, const std::string& variant, int seed) {
    now_.WriteTime(GateFolder::Id(scene, variant, seed), variant == "static" ? 20.0 : 90.0);
  });
  const GateReport slower = Check();
  EXPECT_TRUE(slower.Slower());
  EXPECT_FALSE(slower.Regressed()) << "time alone never does";
  EXPECT_THAT(NoteLines(slower), Contains(HasSubstr("full is slower")));
}

TEST_F(GateTest, OneSlowRunDoesNotMakeAVariantSlower) {
  now_.WriteTime(GateFolder::Id("room", "full", 1), 300.0);
  EXPECT_FALSE(Check().Slower());
}

TEST_F(GateTest, MissingTimeIsNoted) {
  std::filesystem::remove(now_.path() / "jobs" / GateFolder::Id("room", "full", 1) / "timing.json");
  EXPECT_TRUE(Check().Slower());
  EXPECT_FALSE(Check().Regressed());
  EXPECT_THAT(NoteLines(Check()), Contains(HasSubstr("no time of full")));
}

}  // namespace
}  // namespace cvo::reports
