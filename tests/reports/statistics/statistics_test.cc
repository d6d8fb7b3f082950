// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "core/base/error.h"
#include "core/base/rng.h"
#include "reports/statistics/common_frames.h"
#include "reports/statistics/estimate.h"

namespace cvo::reports {
namespace {

Sample Of(const std::string& scene, int body, int seed, double value, double reference = 0.0) {
  return {scene, std::to_string(body), std::to_string(seed), {value}, {reference}};
}

TEST(Statistics, SeedsThenBodiesThenScenes) {
  // Body 1 of room a: (1 + 3) / 2 = 2; body 2: 6, one seed only. Room a: 4. Room b: 10.
  const std::vector<Sample> samples = {Of("a", 1, 0, 1.0), Of("a", 1, 1, 3.0), Of("a", 2, 0, 6.0),
                                       Of("b", 1, 0, 10.0)};
  const auto estimate = EstimateMean(samples, Within::kMean);
  ASSERT_TRUE(estimate);
  EXPECT_DOUBLE_EQ(estimate->value, 7.0);
  EXPECT_EQ(estimate->strata, 2U);
  EXPECT_EQ(estimate->units, 3U);
}

TEST(Statistics, CountsAreSummedWithinAScene) {
  const std::vector<Sample> samples = {Of("a", 1, 0, 1.0), Of("a", 2, 0, 4.0), Of("b", 1, 0, 3.0)};
  EXPECT_DOUBLE_EQ(EstimateMean(samples, Within::kSum)->value, 4.0);
}

TEST(Statistics, FractionsAreOfAllFramesOfAScene) {
  // 30 of 40 and 10 of 60 frames: 40 %, not the mean of 75 % and 17 %.
  const std::vector<Sample> samples = {{"a", "1", "0", {30.0, 40.0}},
                                       {"a", "2", "0", {10.0, 60.0}}};
  EXPECT_DOUBLE_EQ(EstimateMean(samples, Within::kMean)->value, 0.4);
}

TEST(Statistics, NothingToEstimate) {
  EXPECT_FALSE(EstimateMean({}, Within::kMean));
  EXPECT_FALSE(EstimateMean({{"a", "1", "0", {0.0, 0.0}}}, Within::kMean));
  EXPECT_FALSE(EstimateDifference({}, Within::kMean));
}

TEST(Statistics, TheSameSampleTwiceIsAnError) {
  EXPECT_THROW(EstimateMean({Of("a", 1, 0, 1.0), Of("a", 1, 0, 2.0)}, Within::kMean), Error);
}

TEST(Statistics, OneUnitPerStratumHasNoInterval) {
  EXPECT_FALSE(EstimateMean({Of("a", 1, 0, 1.0), Of("b", 1, 0, 2.0)}, Within::kMean)->interval);
}

std::vector<Sample> RandomRooms(std::uint64_t seed, int rooms, int bodies) {
  Rng rng(seed, "rooms");
  std::vector<Sample> samples;
  for (int room = 0; room < rooms; ++room) {
    for (int body = 0; body < bodies; ++body) {
      const double reference = 1.0 + rng.Uniform();
      samples.push_back(Of(std::string(1, static_cast<char>('a' + room)), body, 0,
                           reference + rng.Normal(), reference));
    }
  }
  return samples;
}

TEST(Statistics, OrderOfSamplesDoesNotMatter) {
  std::vector<Sample> samples = RandomRooms(3, 4, 3);
  const auto forward = EstimateDifference(samples, Within::kMean);
  std::reverse(samples.begin(), samples.end());
  const auto backward = EstimateDifference(samples, Within::kMean);
  EXPECT_EQ(forward->difference, backward->difference);
  EXPECT_EQ(forward->interval->low, backward->interval->low);
  EXPECT_EQ(forward->interval->high, backward->interval->high);
}

// Mean over rooms of means of m bodies: its variance is that of a body over (rooms * m), which the
// sample estimates with m - 1. A bootstrap that draws m of m is 33 % below it here.
TEST(Statistics, SpreadOfTheBootstrapIsThatOfTheMean) {
  const int rooms = 4;
  const int bodies = 3;
  const auto strata = AverageRepetitions(RandomRooms(5, rooms, bodies));
  double expected = 0.0;
  for (const auto& units : strata) {
    double mean = 0.0;
    for (const Unit& unit : units) mean += unit.parts[0].sum / bodies;
    for (const Unit& unit : units) {
      expected += std::pow(unit.parts[0].sum - mean, 2) / (bodies - 1) / bodies / (rooms * rooms);
    }
  }
  for (const Within within : {Within::kMean, Within::kSum}) {
    const auto resampled = Bootstrap(strata, within);
    double mean = 0.0;
    double variance = 0.0;
    for (const auto& r : resampled) mean += r[0] / kResamples;
    for (const auto& r : resampled) variance += std::pow(r[0] - mean, 2) / kResamples;
    const double scale = within == Within::kSum ? bodies : 1.0;
    EXPECT_NEAR(variance / (scale * scale), expected, 0.06 * expected);
    EXPECT_NEAR(mean / scale, (*MeanOverStrata(strata, Within::kMean))[0], 0.03);
  }
}

// Without a true difference the interval of 12 bodies covers 0 about as often as it says.
TEST(Statistics, FalseAlarmsAreRare) {
  int alarms = 0;
  constexpr int kTrials = 100;
  for (int trial = 0; trial < kTrials; ++trial) {
    const auto estimate = EstimateDifference(RandomRooms(100 + trial, 4, 3), Within::kMean);
    alarms += estimate->distinguishable ? 1 : 0;
  }
  EXPECT_LE(alarms, 15);
  EXPECT_GE(alarms, 1);
}

TEST(Statistics, PairsRemoveWhatBodiesShare) {
  // Bodies differ by 1, variants by 0.1 with little noise.
  std::vector<Sample> pairs;
  for (int body = 0; body < 8; ++body) {
    pairs.push_back(Of("a", body, 0, 1.1 + body + 0.01 * (body % 2), 1.0 + body));
  }
  const auto estimate = EstimateDifference(pairs, Within::kMean);
  ASSERT_TRUE(estimate && estimate->interval && estimate->percent && estimate->effect);
  EXPECT_NEAR(estimate->difference, 0.105, 1e-12);
  EXPECT_NEAR(estimate->reference, 4.5, 1e-12);
  EXPECT_NEAR(*estimate->percent, 100.0 * 0.105 / 4.5, 1e-9);
  EXPECT_TRUE(estimate->percent_interval->Contains(*estimate->percent));
  EXPECT_NEAR(*estimate->effect, 0.105 / (0.005 * std::sqrt(8.0 / 7.0)), 1e-6);
  EXPECT_TRUE(estimate->distinguishable);
  EXPECT_FALSE(EstimateMean(pairs, Within::kMean)->interval->Contains(4.0 - 1.5));
}

TEST(Statistics, FewPairsAreNeverDistinguishable) {
  std::vector<Sample> pairs;
  for (int body = 0; body < 5; ++body) pairs.push_back(Of("a", body, 0, 2.0 + 0.1 * body, 1.0));
  EXPECT_FALSE(EstimateDifference(pairs, Within::kMean)->distinguishable);
  EXPECT_FALSE(EstimateDifference(pairs, Within::kMean)->interval->Contains(0.0));
  pairs.push_back(Of("a", 5, 0, 2.5, 1.0));
  EXPECT_TRUE(EstimateDifference(pairs, Within::kMean)->distinguishable);
}

TEST(Statistics, EqualVariantsDoNotDiffer) {
  std::vector<Sample> pairs;
  for (int body = 0; body < 8; ++body) pairs.push_back(Of("a", body, 0, body / 6, body / 6));
  const auto estimate = EstimateDifference(pairs, Within::kMean);
  EXPECT_EQ(estimate->difference, 0.0);
  EXPECT_FALSE(estimate->distinguishable);
  EXPECT_FALSE(estimate->effect);
  EXPECT_FALSE(estimate->percent_interval) << "a resampled reference can be 0";
}

TEST(CommonFrames, OnlyFramesThatBothHave) {
  const FrameErrors a = {{0, 1, 3, 5}, {9.0, 3.0, 4.0, 9.0}};
  const FrameErrors b = {{1, 2, 3, 6}, {1.0, 9.0, 7.0, 9.0}};
  const auto both = CommonRootMeanSquares(a, b);
  ASSERT_TRUE(both);
  EXPECT_DOUBLE_EQ(both->first, std::sqrt(12.5));
  EXPECT_DOUBLE_EQ(both->second, 5.0);
  EXPECT_FALSE(CommonRootMeanSquares(a, {{2, 4}, {1.0, 1.0}}));
  EXPECT_FALSE(CommonRootMeanSquares(a, {}));
}

}  // namespace
}  // namespace cvo::reports
