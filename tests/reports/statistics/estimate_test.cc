// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// Tests edge cases of estimates (samples that just suffice or are left out) and values computed by
// hand.
#include "reports/statistics/estimate.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>

#include "reports/statistics/common_frames.h"
#include "reports/statistics/paired_test.h"

namespace cvo::reports {
namespace {

Sample InScene(int scene, double value, double reference) {
  return {"", std::to_string(scene), "1", "0", {value}, {reference}};
}

Sample OfBody(int body, const Part& value, const Part& reference = {}) {
  return {"", "a", std::to_string(body), "0", value, reference};
}

TEST(MiddleRange, CutsTwoAndAHalfPercentOffEachEnd) {
  std::vector<double> values(101);
  std::iota(values.rbegin(), values.rend(), 0.0);
  const auto range = MiddleRange(values);
  EXPECT_NEAR(range->low, 2.5, 1e-12);
  EXPECT_NEAR(range->high, 97.5, 1e-12);
  const auto of_two = MiddleRange({10.0, 20.0});
  EXPECT_NEAR(of_two->low, 10.25, 1e-12);
  EXPECT_NEAR(of_two->high, 19.75, 1e-12);
  const auto of_one = MiddleRange({5.0});
  EXPECT_EQ(of_one->low, 5.0);
  EXPECT_EQ(of_one->high, 5.0);
  EXPECT_FALSE(MiddleRange({}));
}

TEST(Bootstrap, DrawsAllResamplesFromTwoUnitsOn) {
  const std::vector<Unit> two = {{{Part{1.0}, Part{2.0}}}, {{Part{3.0}, Part{6.0}}}};
  const auto means = Bootstrap({two}, Within::kMean);
  ASSERT_EQ(means.size(), std::size_t{kResamples});
  int first = 0;
  for (const auto& [value, reference] : means) {
    EXPECT_TRUE(value == 1.0 || value == 3.0) << "one of two is drawn";
    EXPECT_EQ(reference, 2.0 * value);
    first += value == 1.0 ? 1 : 0;
  }
  EXPECT_NEAR(first, 0.5 * kResamples, 150.0);
  EXPECT_TRUE(Bootstrap({{two[0]}, {two[1]}}, Within::kMean).empty());
  EXPECT_TRUE(Bootstrap({}, Within::kMean).empty());
}

// The draws have a fixed seed, so that published intervals are reproducible.
TEST(Bootstrap, DrawsAreFixed) {
  std::vector<Unit> units;
  for (int i = 0; i < 6; ++i) units.push_back({{Part{static_cast<double>(i * i)}, Part{1.0}}});
  const auto means = Bootstrap({units}, Within::kMean);
  EXPECT_DOUBLE_EQ(means[0][0], 7.0);
  EXPECT_DOUBLE_EQ(means[1][0], 5.6);
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
  EXPECT_DOUBLE_EQ(estimate->reference, 0.1);
  EXPECT_EQ(estimate->scenes, 1U);
  EXPECT_EQ(estimate->bodies, 2U);
}

TEST(Difference, MatchesHandComputedValues) {
  // Differences 1 and 3: mean 2, standard deviation sqrt(2).
  const auto estimate =
      EstimateDifference({InScene(1, 2.0, 1.0), InScene(2, 6.0, 3.0)}, Within::kMean);
  EXPECT_DOUBLE_EQ(estimate->difference, 2.0);
  EXPECT_EQ(estimate->pairs, 2U);
  EXPECT_NEAR(*estimate->effect, std::sqrt(2.0), 1e-12);
  EXPECT_DOUBLE_EQ(*estimate->percent, 100.0);
  EXPECT_DOUBLE_EQ(*estimate->reference_lower, 50.0);
  const auto one = EstimateDifference({InScene(1, 2.0, 1.0)}, Within::kMean);
  EXPECT_DOUBLE_EQ(one->difference, 1.0);
  EXPECT_FALSE(one->effect || one->p_value || one->interval);
}

// Every scene has a quarter more, and so has every draw.
TEST(Difference, OfAConstantRatioIsTheSameInAllDraws) {
  std::vector<Sample> pairs;
  for (int scene = 1; scene <= 7; ++scene) {
    pairs.push_back(InScene(scene, 0.0125 * scene, 0.01 * scene));
  }
  const auto estimate = EstimateDifference(pairs, Within::kMean);
  EXPECT_NEAR(*estimate->percent, 25.0, 1e-9);
  EXPECT_NEAR(estimate->percent_interval->low, 25.0, 1e-9);
  EXPECT_NEAR(estimate->percent_interval->high, 25.0, 1e-9);
  EXPECT_NEAR(*estimate->reference_lower, 20.0, 1e-9);
  EXPECT_NEAR(estimate->reference_lower_interval->low, 20.0, 1e-9);
  EXPECT_NEAR(estimate->reference_lower_interval->high, 20.0, 1e-9);
}

TEST(Difference, OfAConstantOffsetIsTheSameInAllDraws) {
  std::vector<Sample> pairs;
  for (int scene = 1; scene <= 7; ++scene) pairs.push_back(InScene(scene, scene - 0.25, scene));
  const auto estimate = EstimateDifference(pairs, Within::kMean);
  EXPECT_NEAR(estimate->interval->low, -0.25, 1e-12);
  EXPECT_NEAR(estimate->interval->high, -0.25, 1e-12);
  EXPECT_FALSE(estimate->effect) << "no spread";
}

TEST(Difference, PercentagesNeedAPositiveBase) {
  const auto no_reference =
      EstimateDifference({InScene(1, 0.5, -0.5), InScene(2, 0.25, 0.5)}, Within::kMean);
  EXPECT_FALSE(no_reference->percent || no_reference->percent_interval);
  EXPECT_DOUBLE_EQ(*no_reference->reference_lower, 100.0);
  const auto no_value =
      EstimateDifference({InScene(1, 0.25, 0.5), InScene(2, -0.25, 0.25)}, Within::kMean);
  EXPECT_DOUBLE_EQ(*no_value->percent, -100.0);
  EXPECT_FALSE(no_value->reference_lower || no_value->reference_lower_interval);
}

// A spread of differences near 1000 that rounding alone could cause gives no effect size.
TEST(Difference, SpreadFromRoundingIsIgnored) {
  const auto effect = [](double spread) {
    return EstimateDifference({InScene(1, 1000.0 + spread, 0.0), InScene(2, 1000.0 - spread, 0.0)},
                              Within::kMean)
        ->effect;
  };
  EXPECT_FALSE(effect(5e-10));
  EXPECT_TRUE(effect(5e-9));
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

TEST(Difference, StatesTheScenesNeededFromSixScenesOn) {
  std::vector<Sample> pairs;
  for (int scene = 0; scene < 5; ++scene) pairs.push_back(InScene(scene, 1.0 + scene % 2, 1.0));
  EXPECT_FALSE(EstimateDifference(pairs, Within::kMean)->scenes_for_10_percent);
  pairs.push_back(InScene(5, 2.0, 1.0));
  const auto estimate = EstimateDifference(pairs, Within::kMean);
  EXPECT_EQ(estimate->scenes_for_10_percent, PairsNeeded({{0, 1, 0, 1, 0, 1}}, 0.1));
  for (Sample& pair : pairs) pair.reference = {0.0};
  EXPECT_FALSE(EstimateDifference(pairs, Within::kMean)->scenes_for_10_percent);
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

TEST(PairedTest, MatchesHandComputedValuesOfOneStratum) {
  EXPECT_NEAR(*PairedPValue({{4.0, 6.0}}), 1.0 - 2.0 / std::numbers::pi * std::atan(5.0), 1e-12);
  EXPECT_NEAR(*PairedPValue({{-1.0, 3.0}}), 1.0 - 2.0 / std::numbers::pi * std::atan(0.5), 1e-12);
  EXPECT_EQ(*PairedPValue({{0.0, 0.0}}), 1.0);
}

TEST(PairsNeeded, AccountForStrata) {
  const double root = std::sqrt(0.5);
  // Two strata take a degree of freedom each: seven pairs leave five, and
  // (t_5(0.975) + t_5(0.8))^2 = 12.2 <= 7 * 1.5^2.
  EXPECT_EQ(PairsNeeded({{-root, root}, {-root, root}}, 1.5), 7U);
  EXPECT_EQ(PairsNeeded({{-root, root}, {7.0}}, 1.5), 7U) << "one alone has no spread";
  EXPECT_EQ(PairsNeeded({{1.0, 1.0}, {2.0, 2.0}}, 0.1), 3U) << "no spread";
  EXPECT_EQ(PairsNeeded({{-1.0, 1.0}}, 1e-6), 1'000'000U) << "no more than a million";
}

TEST(Holm, AnAdjustedValueIsAtMostOne) {
  EXPECT_EQ(HolmAdjusted({0.9, 0.6}), (std::vector<double>{1.0, 1.0}));
  EXPECT_EQ(HolmAdjusted({0.25, 0.25}), (std::vector<double>{0.5, 0.5}));
}

TEST(CommonFrames, IncludeTheFirstAndTheLast) {
  const FrameErrors a = {{0, 2}, {3.0, 4.0}};
  const FrameErrors b = {{0, 1, 2}, {1.0, 9.0, 7.0}};
  const auto both = CommonRootMeanSquares(a, b);
  EXPECT_DOUBLE_EQ(both->first, std::sqrt(12.5));
  EXPECT_DOUBLE_EQ(both->second, 5.0);
  EXPECT_DOUBLE_EQ(CommonRootMeanSquares({{4}, {2.0}}, {{4}, {3.0}})->second, 3.0);
}

// What was removed from the end is not read.
TEST(CommonFrames, DoNotReadBeyondTheEnd) {
  FrameErrors a = {{1, 5}, {2.0, 8.0}};
  FrameErrors b = {{1, 5}, {3.0, 8.0}};
  for (FrameErrors* errors : {&a, &b}) {
    errors->frames.pop_back();
    errors->position_m.pop_back();
    const auto both = CommonRootMeanSquares(a, b);
    EXPECT_DOUBLE_EQ(both->first, 2.0);
    EXPECT_DOUBLE_EQ(both->second, 3.0);
  }
}

}  // namespace
}  // namespace cvo::reports
