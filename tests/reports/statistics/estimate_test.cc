// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// Estimates: hand-computed values, edge cases, and coverage of their intervals.
#include "reports/statistics/estimate.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <tuple>

#include "core/base/error.h"
#include "core/base/rng.h"

namespace cvo::reports {
namespace {

Sample Of(const std::string& scene, int body, int seed, double value, double reference = 0.0) {
  return {"", scene, std::to_string(body), std::to_string(seed), {value}, {reference}};
}

TEST(Statistics, AverageOverSeedsThenBodiesThenScenes) {
  // Body 1 of room a: (1 + 3) / 2 = 2; body 2: 6, one seed only. Room a: 4. Room b: 10.
  const std::vector<Sample> samples = {Of("a", 1, 0, 1.0), Of("a", 1, 1, 3.0), Of("a", 2, 0, 6.0),
                                       Of("b", 1, 0, 10.0)};
  const auto estimate = EstimateMean(samples, Within::kMean);
  ASSERT_TRUE(estimate);
  EXPECT_DOUBLE_EQ(estimate->value, 7.0);
  EXPECT_EQ(estimate->scenes, 2U);
  EXPECT_EQ(estimate->bodies, 3U);
}

TEST(Statistics, EmptySamplesGiveNoEstimate) {
  EXPECT_FALSE(EstimateMean({}, Within::kMean));
  EXPECT_FALSE(EstimateMean({{"", "a", "1", "0", {0.0, 0.0}}}, Within::kMean));
  EXPECT_FALSE(EstimateDifference({}, Within::kMean));
}

TEST(Statistics, TheSameSampleTwiceIsAnError) {
  EXPECT_THROW(EstimateMean({Of("a", 1, 0, 1.0), Of("a", 1, 0, 2.0)}, Within::kMean), Error);
}

// The bodies of a room share its difficulty: standard deviation 1 between rooms, 0.3 within.
std::vector<Sample> SharedRooms(std::uint64_t seed, int rooms, double mean) {
  Rng rng(seed, "shared");
  std::vector<Sample> samples;
  for (int room = 0; room < rooms; ++room) {
    const double of_room = mean + rng.Normal();
    for (int body = 0; body < 5; ++body) {
      samples.push_back(Of(std::to_string(room), body, 0, 5.0 + of_room + 0.3 * rng.Normal(), 5.0));
    }
  }
  return samples;
}

TEST(Statistics, OrderOfSamplesDoesNotMatter) {
  std::vector<Sample> samples = SharedRooms(3, 4, 0.0);
  const auto forward = EstimateDifference(samples, Within::kMean);
  std::reverse(samples.begin(), samples.end());
  const auto backward = EstimateDifference(samples, Within::kMean);
  EXPECT_EQ(forward->difference, backward->difference);
  EXPECT_EQ(forward->interval->low, backward->interval->low);
  EXPECT_EQ(forward->interval->high, backward->interval->high);
}

// The interval over 24 rooms of 5 bodies has its nominal coverage. One over their 120 bodies would
// be less than half as wide.
TEST(Statistics, IntervalsOverScenesHaveNominalCoverage) {
  constexpr int kTrials = 200;
  int covered = 0;
  for (int trial = 0; trial < kTrials; ++trial) {
    const auto estimate = EstimateDifference(SharedRooms(trial, 24, 0.0), Within::kMean);
    covered += estimate->interval->Contains(0.0) ? 1 : 0;
  }
  EXPECT_GE(covered, 0.90 * kTrials);
  EXPECT_LE(covered, 0.99 * kTrials);
}

TEST(Statistics, OneSceneResamplesItsBodies) {
  const auto estimate = EstimateDifference(SharedRooms(3, 1, 0.0), Within::kMean);
  EXPECT_EQ(estimate->pairs, 5U);
  EXPECT_LT(estimate->interval->high - estimate->interval->low, 1.0);
}

TEST(Statistics, SeedsAndBodiesDoNotNarrowAnInterval) {
  std::vector<Sample> samples = SharedRooms(7, 12, 0.0);
  const auto once = EstimateDifference(samples, Within::kMean);
  for (Sample sample : SharedRooms(7, 12, 0.0)) {
    sample.repetition = "1";
    samples.push_back(sample);
  }
  const auto twice = EstimateDifference(samples, Within::kMean);
  EXPECT_EQ(once->interval->low, twice->interval->low);
  EXPECT_EQ(once->p_value, twice->p_value);
  EXPECT_EQ(once->pairs, 12U);
}

TEST(PairedTest, FalseAlarmsAreOneInTwenty) {
  int alarms = 0;
  constexpr int kTrials = 400;
  for (int trial = 0; trial < kTrials; ++trial) {
    alarms += *EstimateDifference(SharedRooms(trial, 8, 0.0), Within::kMean)->p_value < 0.05;
  }
  EXPECT_GE(alarms, 8);
  EXPECT_LE(alarms, 34);
}

TEST(Statistics, PairingRemovesDifferencesBetweenBodies) {
  // Bodies differ by 1, variants by 0.1 with little noise.
  std::vector<Sample> pairs;
  for (int body = 0; body < 8; ++body) {
    pairs.push_back(Of("a", body, 0, 1.1 + body + 0.01 * (body % 2), 1.0 + body));
  }
  const auto estimate = EstimateDifference(pairs, Within::kMean);
  ASSERT_TRUE(estimate && estimate->interval && estimate->percent);
  EXPECT_NEAR(estimate->difference, 0.105, 1e-12);
  EXPECT_NEAR(estimate->reference_value, 4.5, 1e-12);
  EXPECT_NEAR(*estimate->percent, 100.0 * 0.105 / 4.5, 1e-9);
  EXPECT_LT(*estimate->p_value, 1e-6);
  EXPECT_FALSE(EstimateMean(pairs, Within::kMean)->interval->Contains(4.0 - 1.5));
}

TEST(Statistics, EqualVariantsDoNotDiffer) {
  std::vector<Sample> pairs;
  for (int body = 0; body < 8; ++body) pairs.push_back(Of("a", body, 0, body / 6, body / 6));
  const auto estimate = EstimateDifference(pairs, Within::kMean);
  EXPECT_EQ(estimate->difference, 0.0);
  EXPECT_EQ(estimate->p_value, 1.0);
}

Sample InScene(int scene, double value, double reference) {
  return {"", std::to_string(scene), "1", "0", {value}, {reference}};
}

Sample OfBody(int body, const Part& value, const Part& reference = {}) {
  return {"", "a", std::to_string(body), "0", value, reference};
}

// Each of three bodies has a count of 2: however they are drawn, the sum of the scene is 6.
TEST(Estimate, ResampledSumsKeepTheirScale) {
  const auto estimate =
      EstimateMean({OfBody(1, {2.0}), OfBody(2, {2.0}), OfBody(3, {2.0})}, Within::kSum);
  EXPECT_DOUBLE_EQ(estimate->value, 6.0);
  EXPECT_DOUBLE_EQ(estimate->interval->low, 6.0);
  EXPECT_DOUBLE_EQ(estimate->interval->high, 6.0);
}

TEST(Estimate, AStratumOfTwoIsResampledAndOneOfOneIsNot) {
  const std::vector<Sample> samples = {{"room", "a", "1", "0", {1.0}},
                                       {"room", "b", "1", "0", {3.0}},
                                       {"street", "c", "1", "0", {8.0}}};
  const auto estimate = EstimateMean(samples, Within::kMean);
  EXPECT_DOUBLE_EQ(estimate->value, 5.0) << "families have equal weight";
  EXPECT_DOUBLE_EQ(estimate->interval->low, 4.5);
  EXPECT_DOUBLE_EQ(estimate->interval->high, 5.5);
}

// Body 1 has (30 + 10) / 2 of 40 frames, body 2 has 10 of 60.
TEST(Estimate, RepetitionsOfFractionsAreAveragedFirst) {
  const std::vector<Sample> samples = {{"", "a", "1", "0", {30.0, 40.0}, {8.0, 10.0}},
                                       {"", "a", "1", "1", {10.0, 40.0}, {0.0, 10.0}},
                                       {"", "a", "2", "0", {10.0, 60.0}, {1.0, 40.0}}};
  const auto estimate = EstimateDifference(samples, Within::kMean);
  EXPECT_DOUBLE_EQ(estimate->value, 0.3);
  EXPECT_DOUBLE_EQ(estimate->reference_value, 0.1);
}

TEST(Difference, MatchesHandComputedValues) {
  // Differences 1 and 3: mean 2, standard deviation sqrt(2).
  const auto estimate =
      EstimateDifference({InScene(1, 2.0, 1.0), InScene(2, 6.0, 3.0)}, Within::kMean);
  EXPECT_DOUBLE_EQ(estimate->difference, 2.0);
  EXPECT_EQ(estimate->pairs, 2U);
  EXPECT_DOUBLE_EQ(*estimate->percent, 100.0);
  const auto one = EstimateDifference({InScene(1, 2.0, 1.0)}, Within::kMean);
  EXPECT_DOUBLE_EQ(one->difference, 1.0);
  EXPECT_FALSE(one->p_value || one->interval);
}

TEST(Difference, PercentagesNeedAPositiveBase) {
  const auto no_reference =
      EstimateDifference({InScene(1, 0.5, -0.5), InScene(2, 0.25, 0.5)}, Within::kMean);
  EXPECT_FALSE(no_reference->percent);
}

// A body without a frame in one of the two variants forms no pair.
TEST(Difference, PairsWithoutWeightAreLeftOut) {
  const std::vector<Sample> pairs = {OfBody(1, {3.0}, {1.0}), OfBody(2, {5.0}, {2.0}),
                                     OfBody(3, {9.0}, {4.0})};
  const auto expected = EstimateDifference(pairs, Within::kMean);
  for (const Sample& without : {OfBody(4, {0.0, 0.0}, {7.0}), OfBody(4, {7.0}, {0.0, 0.0})}) {
    std::vector<Sample> more = pairs;
    more.push_back(without);
    EXPECT_EQ(EstimateDifference(more, Within::kMean)->p_value, expected->p_value);
  }
}

// Values of printed tables, two-sided at 5 % and at 1 %.
TEST(Student, QuantilesMatchTables) {
  for (const auto& [degrees, at_5, at_1] : {std::tuple(1, 12.706, 63.657),
                                            {2, 4.303, 9.925},
                                            {3, 3.182, 5.841},
                                            {5, 2.571, 4.032},
                                            {6, 2.447, 3.707},
                                            {10, 2.228, 3.169},
                                            {29, 2.045, 2.756},
                                            {120, 1.980, 2.617}}) {
    EXPECT_NEAR(StudentQuantile(0.025, degrees), at_5, 6e-4) << degrees;
    EXPECT_NEAR(StudentQuantile(0.005, degrees), at_1, 6e-4) << degrees;
  }
}

TEST(PairedTest, IsStudentsTestOverScenes) {
  // Mean 2, standard deviation 1, n = 3: t = 2 sqrt(3) with two degrees of freedom, for which p has
  // a closed form.
  const double t = 2.0 * std::sqrt(3.0);
  EXPECT_NEAR(*PairedPValue({{1.0, 2.0, 3.0}}), 1.0 - t / std::sqrt(2.0 + t * t), 1e-12);
  EXPECT_NEAR(*PairedPValue({{4.0, 6.0}}), 1.0 - 2.0 / std::numbers::pi * std::atan(5.0), 1e-12);
  EXPECT_EQ(*PairedPValue({{-1.0, 1.0}}), 1.0);
  EXPECT_EQ(*PairedPValue({{0.0, 0.0}}), 1.0);
  EXPECT_EQ(*PairedPValue({{2.0, 2.0}}), 0.0);
  EXPECT_FALSE(PairedPValue({{2.0}, {1.0}}));
  EXPECT_FALSE(PairedPValue({}));
}

TEST(PairedTest, MatchesHandComputedStrata) {
  // Two values each, with means 5 and 1 and variances 2 and 8: mean 3 with the variance
  // (2 / 2 + 8 / 2) / 4 and two degrees of freedom.
  const double t = 3.0 / std::sqrt(1.25);
  const double expected = 1.0 - t / std::sqrt(2.0 + t * t);
  EXPECT_NEAR(*PairedPValue({{4.0, 6.0}, {-1.0, 3.0}}), expected, 1e-12);
  EXPECT_NEAR(*PairedPValue({{-4.0, -6.0}, {1.0, -3.0}}), expected, 1e-12) << "two-sided";
  // A stratum of one value contributes to the mean only: (5 + 1) / 2 with variance 1 / 4.
  EXPECT_NEAR(*PairedPValue({{4.0, 6.0}, {1.0}}), 1.0 - 2.0 / std::numbers::pi * std::atan(6.0),
              1e-12);
}

TEST(Holm, StepsDownAndStaysInOrder) {
  EXPECT_THAT(HolmAdjusted({0.01, 0.04, 0.03, 0.005}),
              testing::Pointwise(testing::DoubleNear(1e-12), {0.03, 0.06, 0.06, 0.02}));
  EXPECT_THAT(HolmAdjusted({0.5, 0.9}), testing::ElementsAre(1.0, 1.0));
  EXPECT_THAT(HolmAdjusted({0.25, 0.25}), testing::ElementsAre(0.5, 0.5));
  EXPECT_TRUE(HolmAdjusted({}).empty());
}

}  // namespace
}  // namespace cvo::reports
