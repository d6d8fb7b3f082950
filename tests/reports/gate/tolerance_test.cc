// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/gate/tolerance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "core/base/error.h"
#include "core/base/rng.h"
#include "reports/gate/compare.h"
#include "reports/results/metric_catalogue.h"
#include "reports/statistics/student.h"

namespace cvo::reports {
namespace {

TEST(Student, Quantiles) {
  // From published tables. With one degree of freedom the quantile is a tangent in closed form.
  EXPECT_NEAR(StudentQuantile(0.05, 5), 2.015, 5e-4);
  EXPECT_NEAR(StudentQuantile(0.005, 10), 3.169, 5e-4);
  EXPECT_NEAR(StudentQuantile(0.005, 1), 63.657, 5e-3);
  EXPECT_NEAR(StudentQuantile(0.05, 2), 2.920, 5e-4);
  EXPECT_NEAR(StudentQuantile(1e-4, 1000), 3.719, 2e-2);
  EXPECT_NEAR(StudentQuantile(0.5, 7), 0.0, 1e-9);
  EXPECT_THROW(StudentQuantile(0.6, 7), Error);
  EXPECT_THROW(StudentQuantile(0.1, 0), Error);
}

TEST(MetricEntry, HasADirection) {
  EXPECT_FALSE(FindEntry("camera_ate")->higher_is_better());
  EXPECT_TRUE(FindEntry("object_causal_standing_coverage")->higher_is_better());
  EXPECT_TRUE(FindEntry("moving_recall")->higher_is_better());
  EXPECT_EQ(FindEntry("object_id_switches")->kind, MetricKind::kCount);
  EXPECT_DOUBLE_EQ(FindEntry("object_ate")->Resolution(-0.5), 0.005);
  EXPECT_FALSE(FindEntry("wall_s"));
  EXPECT_FALSE(FindEntry("ate")) << "whose?";
}

TEST(Tolerance, MatchesHandComputedValues) {
  // Two seeds with differences 0 and 2: median 1, deviations 1 and 1, so the robust standard error
  // is 1.4826 / sqrt(2). From the spread of seeds: sqrt(2 * 0.02 / 2) with 3 degrees of freedom.
  const std::vector<SceneDifferences> scattered = {{{0.0, 2.0}, 0.02, 3}};
  EXPECT_NEAR(Tolerance(scattered, 1), 3.0 * 1.4826 / std::sqrt(2.0), 1e-12);
  const std::vector<SceneDifferences> quiet = {{{0.1, 0.1}, 0.02, 3}};
  EXPECT_NEAR(Tolerance(quiet, 1), StudentQuantile(0.01, 3) * std::sqrt(0.02), 1e-12);
  EXPECT_GT(Tolerance(quiet, 100), Tolerance(quiet, 1)) << "more comparisons, more chances";
  EXPECT_EQ(Tolerance({}, 1), 0.0);
}

TEST(Tolerance, OneBrokenSceneIsNotMasked) {
  std::vector<SceneDifferences> scenes(4, {{0.0, 0.0}, 0.01, 10});
  scenes[2].worse_by = {30.0, 50.0};
  EXPECT_GT(MeanDifference(scenes), 10.0 * Tolerance(scenes, 100));
}

TEST(Tolerance, MeanIsOverScenes) {
  EXPECT_DOUBLE_EQ(MeanDifference({{{1.0, 3.0}, 1.0, 1}, {{5.0}, 1.0, 1}, {{}, 1.0, 1}}), 3.5);
}

// Three scenes that differ in noise and scale, under three variants, with two errors and two shares
// as metrics.
struct World {
  Baseline baseline;
  std::vector<RunPair> pairs;
};

constexpr int kSeeds = 6;
constexpr int kGateSeeds = 2;

using Noise = std::function<double(Rng&)>;

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
    world.pairs.push_back({&world.baseline.jobs[job], now[job], std::nullopt});
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

TEST(Tolerance, SeedNoiseRarelyRaisesAlarms) { EXPECT_LE(Alarms(1000, Normal), 15); }

TEST(Tolerance, NoiseWithOutliersRarelyRaisesAlarms) { EXPECT_LE(Alarms(500, HeavyTailed), 25); }

TEST(Tolerance, RegressionOfFourSpreadsRaisesAlarms) { EXPECT_GE(Alarms(100, Normal, 4.0), 95); }

TEST(Tolerance, SpreadIsPooledOverVariantsForOneWithFewSeeds) {
  Baseline baseline;
  baseline.metrics = {{"camera_ate", MetricUnit::kMetres, {}}};
  const auto add = [&](const char* variant, std::uint64_t seed, double value) {
    BaselineJob job;
    job.keys = {{"sequence", "room"}, {"variant", variant}};
    job.seed = seed;
    job.values["camera_ate"] = value;
    baseline.jobs.push_back(job);
  };
  const auto spread = [&](const char* variant) {
    return SpreadOfSeeds(baseline, baseline.metrics[0],
                         {{"sequence", "room"}, {"variant", variant}});
  };
  add("full", 1, 1.0);
  EXPECT_FALSE(spread("full")) << "one seed has no spread";
  add("full", 2, 1.0);
  // Equal values: what remains is the resolution, a hundredth of the mean, over two runs.
  EXPECT_DOUBLE_EQ(spread("full")->variance, 1e-4 / 2.0);
  EXPECT_EQ(spread("full")->degrees, 1U);
  add("static", 1, 8.0);
  add("static", 2, 12.0);
  EXPECT_DOUBLE_EQ(spread("static")->variance, 8.0) << "its own: it is further apart than both";
  EXPECT_EQ(spread("static")->degrees, 1U);
  EXPECT_DOUBLE_EQ(spread("full")->variance, 1e-4 / 2.0);
  add("2d3d", 1, 1.0);
  EXPECT_DOUBLE_EQ(spread("2d3d")->variance, 0.08 / 2.0) << "0 and, relative to 10 m, 8 / 100";
  EXPECT_EQ(spread("2d3d")->degrees, 2U);
  EXPECT_FALSE(spread("2d"));
}

}  // namespace
}  // namespace cvo::reports
