// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/base/rng.h"
#include "core/record/metric_catalogue.h"
#include "reports/gate/check_runs.h"
#include "reports/statistics/estimate.h"
#include "tests/reports/gate/gate_folder.h"
#include "tests/support/error_message.h"

namespace cvo::reports {
namespace {

using test::GateFolder;
using test::Json;
using ::testing::AllOf;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

class GateTest : public ::testing::Test {
 protected:
  GateReport Check(bool exact = false) const {
    return CheckRuns(now_.path(), MakeBaseline(then_.path()), exact);
  }
  // The only problem of a check after `edit` has changed the run of full on room with seed 1.
  std::string ProblemAfter(const std::function<void(Json&)>& edit) const {
    now_.Edit(kRun, edit);
    const GateReport report = Check();
    EXPECT_TRUE(report.Regressed());
    EXPECT_EQ(report.problems.size(), 1U);
    return report.problems.empty() ? "" : report.problems[0];
  }
  // Scales the ATE of every run of the scene and variant.
  void Scale(const std::string& scene, const std::string& variant, double factor) const {
    now_.ForEachJob([&](const std::string& s, const std::string& v, int seed) {
      if (s != scene || v != variant) return;
      now_.EditMetric(GateFolder::Id(s, v, seed), 1, factor * GateFolder::Ate(s, seed));
    });
  }
  static void RunWith(const GateFolder& folder, const char* compiler) {
    folder.ForEachJob([&](const std::string& scene, const std::string& variant, int seed) {
      folder.Edit(GateFolder::Id(scene, variant, seed), [&](Json& result) {
        result["build"]["compiler"] = compiler;
        result["build"]["cpu_level"] = "avx2";
      });
    });
  }

  const std::string kRun = GateFolder::Id("room", "full", 1);
  const std::string kLabel = "full on room, detections good, seed 1: ";
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
  EXPECT_THAT(report.notes, IsEmpty());
  EXPECT_THAT(GateText(report), AllOf(HasSubstr("12 the same\n"), Not(HasSubstr("tolerance  "))));
  EXPECT_THAT(GateMarkdown(report), testing::StartsWith("### No regression\n\n    gate: 16 "));
  EXPECT_THAT(GateJunit(report), AllOf(HasSubstr("failures=\"0\""), HasSubstr("<system-out>gate")));
}

TEST_F(GateTest, SceneThatGetsWorseIsFound) {
  Scale("room", "full", 3.0);
  const GateReport report = Check();
  EXPECT_TRUE(report.Regressed());
  EXPECT_THAT(report.problems, IsEmpty());
  ASSERT_EQ(report.Count(Verdict::kWorse), 2U) << "on its scene and over both";
  EXPECT_THAT(GateText(report),
              AllOf(HasSubstr("2 worse, 0 better"),
                    HasSubstr("full     room, detections good  camera_ate (m)  0.01245   0.03735  "
                              "+200 %  ")));
  EXPECT_THAT(GateMarkdown(report), testing::StartsWith("### Regression\n"));
  EXPECT_THAT(GateJunit(report), HasSubstr("<failure message=\"regression\">gate: 16 runs"));
}

TEST_F(GateTest, ChangesWithinSeedNoiseAreTolerated) {
  Scale("room", "full", 1.02);
  Scale("street", "static", 0.99);
  const GateReport report = Check();
  EXPECT_FALSE(report.Regressed());
  // Two changes, each on its scene and over both scenes.
  EXPECT_EQ(report.Count(Verdict::kWithin), 4U);
}

TEST_F(GateTest, ValuesAreHeldExactlyWhereThePlatformIsTheBaselines) {
  RunWith(then_, "GNU 12");
  RunWith(now_, "GNU 12");
  EXPECT_FALSE(Check(true).Failed());
  EXPECT_THAT(Check(true).notes, IsEmpty());
  Scale("room", "full", 0.999999);
  EXPECT_FALSE(Check().Failed());
  const GateReport changed = Check(true);
  EXPECT_TRUE(changed.Failed());
  EXPECT_FALSE(changed.Regressed());
  EXPECT_EQ(changed.changed, 4U) << "one of each seed";
  EXPECT_THAT(GateText(changed), HasSubstr("4 of 32 values differ from the baseline"));
  EXPECT_THAT(GateMarkdown(changed), testing::StartsWith("### Changed\n"));
  EXPECT_THAT(GateJunit(changed), HasSubstr("failures=\"1\""));
  now_.Edit(kRun, [](Json& result) { result["build"]["compiler"] = "GNU 14"; });
  EXPECT_EQ(Check(true).changed, 3U) << "one run of another compiler frees no other";
  EXPECT_THAT(Check(true).notes, Contains(AllOf(HasSubstr("exactness is not checked"),
                                                HasSubstr("GNU 14"), HasSubstr("GNU 12"))));
  RunWith(now_, "GNU 14");
  EXPECT_FALSE(Check(true).Failed());
}

TEST_F(GateTest, OptionsThatDifferAreNamed) {
  const auto set = [](const GateFolder& folder, int features) {
    folder.ForEachJob([&](const std::string& scene, const std::string& variant, int seed) {
      folder.Edit(GateFolder::Id(scene, variant, seed), [&](Json& result) {
        result["options"] = {{"orb", {{"features", features}}}};
      });
    });
  };
  set(then_, 2000);
  set(now_, 300);
  EXPECT_THAT(Check().notes,
              testing::ElementsAre("option orb.features is 300, in the baseline 2000"));
}

TEST_F(GateTest, ABaselineOfAnotherSuiteIsRefused) {
  now_.EditPlan([](Json& plan) { plan["suite"]["name"] = "other"; });
  EXPECT_THAT(ErrorMessage([&] { Check(); }), HasSubstr("the suite \"other\", expected the base"));
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
  EXPECT_THAT(back.notes, Contains(HasSubstr("update the baseline to hold this level")));
}

TEST_F(GateTest, MissingMetricFails) {
  EXPECT_EQ(ProblemAfter([](Json& result) { result["metrics"].erase(1); }),
            kLabel + "no camera_ate");
}

TEST_F(GateTest, LostRunFails) {
  EXPECT_EQ(ProblemAfter([](Json& result) { result["status"] = "lost"; }),
            kLabel + "ended as lost");
}

TEST_F(GateTest, AnotherUnitFails) {
  EXPECT_EQ(ProblemAfter([](Json& result) { result["metrics"][1]["unit"] = "rad"; }),
            "camera_ate: in rad, in the baseline in m");
}

TEST_F(GateTest, AnotherNumberOfFramesFailsAndIsNotCompared) {
  EXPECT_EQ(ProblemAfter([](Json& result) { result["sequence"]["frames"] = 10; }),
            kLabel + "10 frames, in the baseline 60");
  EXPECT_EQ(Check().runs, 15U);
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
  EXPECT_THAT(
      report.problems[0],
      HasSubstr("camera_ate: another contract: alignment \"none\", in the baseline \"SE(3)"));
  EXPECT_EQ(report.comparisons.size(), 6U) << "the coverage still is";
}

TEST_F(GateTest, MissingFailedAndUnfinishedJobsFail) {
  std::filesystem::remove_all(now_.path() / "jobs" / kRun);
  EXPECT_THAT(Check().problems, testing::ElementsAre(kLabel + "not run"));
  now_.Write("failed/" + kRun + ".json", Json{{"schema_version", 1},
                                              {"kind", "failure"},
                                              {"job", kRun},
                                              {"message", "killed by\nsignal 9"},
                                              {"log", ""}}
                                             .dump());
  EXPECT_THAT(Check().problems, testing::ElementsAre(kLabel + "failed: killed by signal 9"));
  now_.EditPlan([](Json& plan) { plan["jobs"].erase(0); });
  EXPECT_THAT(
      Check().problems,
      testing::ElementsAre(kLabel + "in the baseline, but not among the jobs of this folder"));
}

TEST_F(GateTest, AFolderWithoutResultsFails) {
  const Baseline baseline = MakeBaseline(then_.path());
  std::filesystem::remove_all(now_.path() / "jobs");
  const GateReport report = CheckRuns(now_.path(), baseline);
  EXPECT_EQ(report.problems.size(), 17U);
  EXPECT_EQ(report.problems.back(), "gate: nothing was compared");
  EXPECT_EQ(report.runs, 0U);
  EXPECT_THAT(GateText(report), AllOf(HasSubstr(", 17 problems\n"), Not(HasSubstr("more\n"))));
  test::TempFolder empty;
  EXPECT_THAT(ErrorMessage([&] { CheckRuns(empty.path(), baseline); }), HasSubstr("no such file"));
}

TEST_F(GateTest, OtherImagesAndJobsAreNoted) {
  now_.Edit(kRun, [](Json& result) { result["sequence"]["content"] = "other"; });
  EXPECT_THAT(Check().notes, Contains(HasSubstr("1 runs read other images")));
  const Baseline baseline = MakeBaseline(GateFolder(3).path());
  EXPECT_THAT(CheckRuns(now_.path(), baseline).notes, Contains("4 jobs are not in the baseline"));
}

TEST(Gate, SeedsBeyondThoseOfTheGateNeedNotRun) {
  const GateFolder then(8);
  const GateFolder now(2);
  const GateReport report = CheckRuns(now.path(), MakeBaseline(then.path(), 2));
  EXPECT_FALSE(report.Regressed());
  EXPECT_EQ(report.runs, 8U);
  EXPECT_TRUE(CheckRuns(now.path(), MakeBaseline(then.path())).Regressed());
}

TEST(GateText, IsEscapedAndLongListsAreTruncated) {
  GateReport report;
  report.suite = "a<b";
  report.problems.assign(50, "2d on \"room\" & more");
  EXPECT_THAT(GateText(report), HasSubstr("  2d on \"room\" & more\n  and 30 more\n"));
  EXPECT_THAT(GateJunit(report), AllOf(HasSubstr("<testsuite name=\"clustervo.a&lt;b\" tests=\"1\" "
                                                 "failures=\"1\""),
                                       HasSubstr("2d on &quot;room&quot; &amp; more")));
}

// Three scenes that differ in noise and scale, under three variants, with two errors and two shares
// as metrics.
struct World {
  Baseline baseline;
  std::vector<RunPair> pairs;
};
constexpr int kSeeds = 16;
constexpr int kGateSeeds = 2;

using Noise = double (*)(Rng&);

World RandomWorld(std::uint64_t seed, const Noise& noise, double shift) {
  Rng rng(seed, "gate");
  World world;
  const std::vector<std::string> metrics = {"camera_ate", "object_ate", "object_coverage",
                                            "moving_recall"};
  for (const std::string& metric : metrics)
    world.baseline.metrics.push_back({metric, MetricUnit::kMetres, {}});
  std::vector<std::map<std::string, double>> now;
  for (int job = 0; job < 3 * 3 * kSeeds; ++job) {
    const int scene = job / (3 * kSeeds);
    const int variant = job / kSeeds % 3;
    BaselineJob made;
    made.keys = {{"sequence", StrCat("scene ", scene)}, {"variant", StrCat("variant ", variant)}};
    made.seed = static_cast<std::uint64_t>(job % kSeeds);
    now.emplace_back();
    for (std::size_t m = 0; m < metrics.size(); ++m) {
      const bool error = m < 2;
      const double size = error ? std::pow(4.0, scene) * (1.0 + variant) : 0.8;
      const double spread = error ? size * (0.05 + 0.1 * variant) : 0.02 * (1.0 + scene);
      made.values[metrics[m]] = size + spread * noise(rng);
      now.back()[metrics[m]] = size + spread * (noise(rng) + (error ? shift : -shift));
    }
    world.baseline.jobs.push_back(std::move(made));
  }
  for (std::size_t job = 0; job < now.size(); ++job) {
    if (world.baseline.jobs[job].seed >= kGateSeeds) continue;
    world.pairs.push_back({&world.baseline.jobs[job], now[job]});
  }
  return world;
}

int Alarms(int trials, const Noise& noise, double shift = 0.0) {
  int alarms = 0;
  for (int trial = 0; trial < trials; ++trial) {
    const World world = RandomWorld(static_cast<std::uint64_t>(trial), noise, shift);
    const auto comparisons = CompareValues(world.baseline, world.pairs);
    EXPECT_EQ(comparisons.size(), 3U * 4U * 4U);
    alarms += std::any_of(comparisons.begin(), comparisons.end(),
                          [](const Comparison& c) { return c.verdict == Verdict::kWorse; });
  }
  return alarms;
}

double Normal(Rng& rng) { return rng.Normal(); }
// One run in twenty is drawn with three times the usual spread.
double HeavyTailed(Rng& rng) {
  const double factor = rng.Uniform() < 0.05 ? 3.0 : 1.0;
  return factor * rng.Normal();
}

TEST(Tolerance, SeedNoiseRarelyRaisesAlarms) { EXPECT_LE(Alarms(500, Normal), 10); }

TEST(Tolerance, NoiseWithOutliersRarelyRaisesAlarms) { EXPECT_LE(Alarms(250, HeavyTailed), 15); }

TEST(Tolerance, RegressionOfFourSpreadsRaisesAlarms) { EXPECT_GE(Alarms(100, Normal, 4.0), 95); }

TEST(Tolerance, MatchesHandComputedValues) {
  Baseline baseline;
  baseline.metrics = {{"camera_ate", MetricUnit::kMetres, {}}};
  const auto add = [&](const char* scene, std::uint64_t seed, double value) {
    baseline.jobs.push_back({.keys = {{"sequence", scene}, {"variant", "full"}},
                             .seed = seed,
                             .type = "",
                             .content = "",
                             .images = "",
                             .frames = {},
                             .status = "ok",
                             .values = {{"camera_ate", value}}});
  };
  const auto compare = [&](double worse_by) {
    std::vector<RunPair> pairs;
    for (const BaselineJob& job : baseline.jobs) {
      pairs.push_back({&job, {{"camera_ate", job.values.at("camera_ate") + worse_by}}});
    }
    return CompareValues(baseline, pairs);
  };
  add("room", 1, 8.0);
  EXPECT_THAT(compare(1.0), IsEmpty()) << "one seed has no spread";
  add("room", 2, 12.0);
  // Of the logarithms, a variance of half the squared distance; two means of two runs each.
  const double spread = std::log(12.0 / 8.0) / std::sqrt(2.0);
  const auto quantile = [](double comparisons, int degrees) {
    return StudentQuantile(0.005 / comparisons, degrees);
  };
  const double by_hand = std::expm1(quantile(1.0, 1) * spread);
  EXPECT_NEAR(compare(0.0)[0].tolerance, by_hand, 1e-9 * by_hand);
  EXPECT_EQ(compare(1.0)[0].verdict, Verdict::kBlind) << "two seeds cannot tell";
  for (std::uint64_t seed = 3; seed <= 9; ++seed) add("room", seed, seed % 2 == 0 ? 12.0 : 8.0);
  const double tolerance = compare(0.0)[0].tolerance;
  EXPECT_NEAR(tolerance, std::expm1(quantile(1.0, 8) * spread * std::sqrt(40.0 / 72.0 * 2.0 / 9.0)),
              1e-9);
  EXPECT_EQ(compare(0.9 * 8.0 * tolerance)[0].verdict, Verdict::kWithin);
  EXPECT_EQ(compare(1.2 * 12.0 * tolerance)[0].verdict, Verdict::kWorse);
  // Equal values: what remains is the resolution, a hundredth of the mean.
  for (std::uint64_t seed = 1; seed <= 9; ++seed) add("street", seed, 1.0);
  const std::vector<Comparison> both = compare(0.0);
  ASSERT_EQ(both.size(), 3U);
  EXPECT_NEAR(both[2].tolerance, std::expm1(quantile(2.0, 8) * 0.01 * std::sqrt(2.0 / 81.0)), 1e-9);
  EXPECT_LT(both[0].tolerance, 0.5 * both[1].tolerance) << "the steady scene weighs more";
}

TEST(Tolerance, AFractionThatCannotFailIsNotCounted) {
  Baseline baseline;
  baseline.metrics = {{"moving_recall", MetricUnit::kOne, {}}};
  std::vector<RunPair> pairs;
  for (const double value : {0.9, 0.98}) {
    baseline.jobs.push_back({.keys = {{"sequence", "room"}, {"variant", "full"}},
                             .seed = baseline.jobs.size(),
                             .type = "",
                             .content = "",
                             .images = "",
                             .frames = {},
                             .status = "ok",
                             .values = {{"moving_recall", value}}});
  }
  for (const BaselineJob& job : baseline.jobs) pairs.push_back({&job, {{"moving_recall", 0.0}}});
  EXPECT_EQ(CompareValues(baseline, pairs).at(0).verdict, Verdict::kBlind);
}

}  // namespace
}  // namespace cvo::reports
