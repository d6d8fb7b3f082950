// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// Paired tests: closed forms, printed tables and the stated power.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <tuple>

#include "core/base/rng.h"
#include "reports/statistics/estimate.h"

namespace cvo::reports {
namespace {

// Closed forms for one to four degrees of freedom.
TEST(Student, TailOfFewDegrees) {
  for (const double t : {0.0, 0.3, 1.0, 2.5, 40.0}) {
    const double theta1 = std::atan(t);
    EXPECT_NEAR(StudentTail(t, 1), 0.5 - theta1 / std::numbers::pi, 1e-14) << t;
    EXPECT_NEAR(StudentTail(t, 2), 0.5 - 0.5 * t / std::sqrt(2.0 + t * t), 1e-14) << t;
    const double theta3 = std::atan(t / std::sqrt(3.0));
    EXPECT_NEAR(StudentTail(t, 3),
                0.5 - (theta3 + std::sin(theta3) * std::cos(theta3)) / std::numbers::pi, 1e-14)
        << t;
    const double sine4 = t / std::sqrt(4.0 + t * t);
    EXPECT_NEAR(StudentTail(t, 4), 0.5 - 0.25 * sine4 * (3.0 - sine4 * sine4), 1e-14) << t;
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

TEST(Student, QuantileIsTheInverseOfTheTail) {
  for (const int degrees : {1, 2, 7, 8, 400}) {
    for (const double tail : {1e-9, 1e-3, 0.2, 0.49}) {
      const double t = StudentQuantile(tail, degrees);
      EXPECT_NEAR(StudentTail(t, degrees) / tail, 1.0, 1e-6) << degrees << " " << tail;
    }
    EXPECT_NEAR(StudentQuantile(0.5, degrees), 0.0, 1e-12);
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

TEST(PairsNeeded, AccountForStrata) {
  const double root = std::sqrt(0.5);
  // One stratum: (t_5(0.975) + t_5(0.8))^2 = 12.2 <= 6 * 1.5^2 and with t_4, 13.8 > 5 * 1.5^2.
  EXPECT_EQ(PairsNeeded({{-root, root}}, 1.5), 6U);
  // Two strata take a degree of freedom each: seven pairs leave five, and
  // (t_5(0.975) + t_5(0.8))^2 = 12.2 <= 7 * 1.5^2.
  EXPECT_EQ(PairsNeeded({{-root, root}, {-root, root}}, 1.5), 7U);
  EXPECT_EQ(PairsNeeded({{-root, root}, {7.0}}, 1.5), 7U) << "one alone has no spread";
  EXPECT_EQ(PairsNeeded({{1.0, 1.0}, {2.0, 2.0}}, 0.1), 3U) << "no spread";
  EXPECT_EQ(PairsNeeded({{-1.0, 1.0}}, 1e-6), 1'000'000U) << "no more than a million";
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
