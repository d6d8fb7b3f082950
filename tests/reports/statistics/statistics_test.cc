// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "core/base/error.h"
#include "core/base/rng.h"
#include "reports/statistics/aligned_errors.h"
#include "reports/statistics/common_frames.h"
#include "reports/statistics/estimate.h"
#include "reports/statistics/paired_test.h"

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

TEST(Statistics, CountsAreSummedWithinAScene) {
  const std::vector<Sample> samples = {Of("a", 1, 0, 1.0), Of("a", 2, 0, 4.0), Of("b", 1, 0, 3.0)};
  EXPECT_DOUBLE_EQ(EstimateMean(samples, Within::kSum)->value, 4.0);
}

TEST(Statistics, FractionsAreOfAllFramesOfAScene) {
  // 30 of 40 and 10 of 60 frames: 40 %, not the mean of 75 % and 17 %.
  const std::vector<Sample> samples = {{"", "a", "1", "0", {30.0, 40.0}},
                                       {"", "a", "2", "0", {10.0, 60.0}}};
  EXPECT_DOUBLE_EQ(EstimateMean(samples, Within::kMean)->value, 0.4);
}

TEST(Statistics, EmptySamplesGiveNoEstimate) {
  EXPECT_FALSE(EstimateMean({}, Within::kMean));
  EXPECT_FALSE(EstimateMean({{"", "a", "1", "0", {0.0, 0.0}}}, Within::kMean));
  EXPECT_FALSE(EstimateDifference({}, Within::kMean));
}

TEST(Statistics, TheSameSampleTwiceIsAnError) {
  EXPECT_THROW(EstimateMean({Of("a", 1, 0, 1.0), Of("a", 1, 0, 2.0)}, Within::kMean), Error);
}

TEST(Statistics, FamiliesHaveEqualWeightRegardlessOfScenes) {
  const std::vector<Sample> samples = {{"room", "a", "1", "0", {1.0}},
                                       {"room", "b", "1", "0", {3.0}},
                                       {"street", "c", "1", "0", {8.0}}};
  const auto estimate = EstimateMean(samples, Within::kMean);
  EXPECT_DOUBLE_EQ(estimate->value, 5.0);
  EXPECT_TRUE(estimate->interval) << "of the rooms; one street is taken as it is";
}

TEST(Statistics, OneBodyHasNoInterval) {
  EXPECT_FALSE(EstimateMean({Of("a", 1, 0, 1.0), Of("a", 1, 1, 2.0)}, Within::kMean)->interval);
}

std::vector<Sample> RandomRooms(std::uint64_t seed, int rooms, int bodies) {
  Rng rng(seed, "rooms");
  std::vector<Sample> samples;
  for (int room = 0; room < rooms; ++room) {
    for (int body = 0; body < bodies; ++body) {
      const double reference = 1.0 + rng.Uniform();
      samples.push_back(Of(std::to_string(room), body, 0, reference + rng.Normal(), reference));
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
  EXPECT_EQ(estimate->scenes, 1U);
  EXPECT_EQ(estimate->pairs, 5U);
  EXPECT_FALSE(estimate->scenes_for_10_percent);
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

// The variance over resamples is that of the mean over n scenes; drawing n of n scenes would give
// (n - 1) / n of it.
TEST(Statistics, SpreadOfTheBootstrapIsThatOfTheMean) {
  constexpr int kRooms = 5;
  const auto strata = GroupSamples(SharedRooms(5, kRooms, 0.0), Within::kMean);
  const std::vector<Unit>& rooms = strata->units[0];
  double mean = 0.0;
  double expected = 0.0;
  for (const Unit& room : rooms) mean += room.parts[0].sum / kRooms;
  for (const Unit& room : rooms) {
    expected += std::pow(room.parts[0].sum - mean, 2) / (kRooms - 1) / kRooms;
  }
  double variance = 0.0;
  for (const auto& r : Bootstrap(strata->units, strata->within)) {
    variance += std::pow(r[0] - mean, 2) / kResamples;
  }
  EXPECT_NEAR(variance, expected, 0.06 * expected);
}

TEST(PairedTest, IsStudentsTestOverScenes) {
  // Mean 2, standard deviation 1, n = 3: t = 2 sqrt(3) with two degrees of freedom, for which p has
  // a closed form.
  const double t = 2.0 * std::sqrt(3.0);
  EXPECT_NEAR(*PairedPValue({{1.0, 2.0, 3.0}}), 1.0 - t / std::sqrt(2.0 + t * t), 1e-12);
  EXPECT_EQ(*PairedPValue({{-1.0, 1.0}}), 1.0);
  EXPECT_EQ(*PairedPValue({{2.0, 2.0}}), 0.0);
  EXPECT_FALSE(PairedPValue({{2.0}, {1.0}}));
  EXPECT_FALSE(PairedPValue({}));
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

// With the number of scenes from PairsNeeded, the difference is detected four times out of five.
TEST(PairedTest, HasTheStatedPower) {
  Rng rng(1, "power");
  const auto draw = [&rng](std::size_t n, double mean) {
    Differences differences(1);
    for (std::size_t i = 0; i < n; ++i) differences[0].push_back(mean + rng.Normal());
    return differences;
  };
  const std::size_t needed = *PairsNeeded(draw(4000, 0.0), 0.5);
  EXPECT_NEAR(static_cast<double>(needed), 33.4, 2.5) << "of textbooks, for half a deviation";
  int told = 0;
  constexpr int kTrials = 500;
  for (int trial = 0; trial < kTrials; ++trial) told += *PairedPValue(draw(needed, 0.5)) < 0.05;
  EXPECT_NEAR(told / double{kTrials}, 0.8, 0.06);
  EXPECT_EQ(*PairsNeeded({{1.0, 1.0}}, 0.1), 2U) << "no spread";
  EXPECT_FALSE(PairsNeeded({{1.0}}, 0.1));
}

TEST(Holm, StepsDownAndStaysInOrder) {
  EXPECT_THAT(HolmAdjusted({0.01, 0.04, 0.03, 0.005}),
              testing::Pointwise(testing::DoubleNear(1e-12), {0.03, 0.06, 0.06, 0.02}));
  EXPECT_THAT(HolmAdjusted({0.5, 0.9}), testing::ElementsAre(1.0, 1.0));
  EXPECT_TRUE(HolmAdjusted({}).empty());
}

// A difference of 1.5 standard deviations needs 6 pairs, since
// (t_5(0.975) + t_5(0.8))^2 = 12.2 <= 6 * 1.5^2 and (t_4(0.975) + t_4(0.8))^2 = 13.8 > 5 * 1.5^2.
TEST(PairedTest, PairsNeededUseTheirOwnDegreesOfFreedom) {
  EXPECT_EQ(PairsNeeded({{-std::sqrt(0.5), std::sqrt(0.5)}}, 1.5), 6U);
}

TEST(Holm, IsMonotoneAndNeverBelowThePValueItself) {
  Rng rng(2, "holm");
  for (int trial = 0; trial < 50; ++trial) {
    std::vector<double> p(10);
    for (double& value : p) value = rng.Uniform();
    const std::vector<double> adjusted = HolmAdjusted(p);
    for (std::size_t i = 0; i < p.size(); ++i) {
      EXPECT_GE(adjusted[i], p[i]);
      for (std::size_t j = 0; j < p.size(); ++j) {
        if (p[i] < p[j]) {
          EXPECT_LE(adjusted[i], adjusted[j]);
        }
      }
    }
  }
}

TEST(Statistics, PairingRemovesDifferencesBetweenBodies) {
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
  EXPECT_LT(*estimate->p_value, 1e-6);
  EXPECT_FALSE(EstimateMean(pairs, Within::kMean)->interval->Contains(4.0 - 1.5));
}

TEST(Statistics, EqualVariantsDoNotDiffer) {
  std::vector<Sample> pairs;
  for (int body = 0; body < 8; ++body) pairs.push_back(Of("a", body, 0, body / 6, body / 6));
  const auto estimate = EstimateDifference(pairs, Within::kMean);
  EXPECT_EQ(estimate->difference, 0.0);
  EXPECT_EQ(estimate->p_value, 1.0);
  EXPECT_FALSE(estimate->effect);
  EXPECT_FALSE(estimate->percent_interval) << "a resampled reference can be 0";
}

TEST(AlignedErrors, IgnoreRotationAndTranslation) {
  const std::vector<std::array<double, 3>> truth = {
      {0.0, 0.0, 0.0}, {1.0, 0.0, 0.2}, {2.0, 0.5, 0.1}, {2.5, 1.5, -0.3}};
  std::vector<std::array<double, 3>> moved;  // rotated by 90 degrees about z, then translated
  for (const auto& [x, y, z] : truth) moved.push_back({5.0 - y, x - 7.0, z + 1.0});
  for (const double error : AlignedErrors(moved, truth)) EXPECT_NEAR(error, 0.0, 1e-12);
}

TEST(AlignedErrors, OfAStretchedSquare) {
  // By symmetry the best translation and rotation are zero: 0.5 m at each corner.
  const std::vector<std::array<double, 3>> truth = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
  std::vector<std::array<double, 3>> wide = truth;
  for (auto& point : wide) point[0] *= 1.5;
  for (const double error : AlignedErrors(wide, truth)) EXPECT_NEAR(error, 0.5, 1e-12);
  EXPECT_TRUE(AlignedErrors({}, {}).empty());
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
