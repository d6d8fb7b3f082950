// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/rng.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "core/base/error.h"

namespace cvo {
namespace {

using testing::ElementsAre;

std::vector<std::uint64_t> Draw(Rng rng, int count) {
  std::vector<std::uint64_t> numbers;
  for (int i = 0; i < count; ++i) numbers.push_back(rng.NextU64());
  return numbers;
}

// The values are from an independent implementation of SplitMix64, FNV-1a and xoshiro256**. If they
// change, so does every seeded result.
TEST(Rng, GoldenValues) {
  EXPECT_THAT(Draw(Rng(1, "ransac"), 3),
              ElementsAre(0x732B2FDE8EC4671u, 0x2F745CAC8CA43757u, 0x6C4C54E44526B3BFu));
  EXPECT_THAT(Draw(Rng(1, "scene"), 3),
              ElementsAre(0x230B6A6EF5CAD983u, 0x68E943285E79E105u, 0x968D51489E007525u));
  EXPECT_THAT(Draw(Rng(2, "ransac"), 3),
              ElementsAre(0xF0C1D37E20812EADu, 0x37C6C327CB0FB012u, 0x10B61FE89DE01A70u));
  Rng rng(1, "ransac");
  EXPECT_EQ(rng.Uniform(), 0.028117358197889963);
  EXPECT_EQ(rng.Uniform(), 0.1853692933333526);
}

double Correlation(Rng a, Rng b, int count) {
  double sum = 0.0;
  for (int i = 0; i < count; ++i) sum += (a.Uniform() - 0.5) * (b.Uniform() - 0.5);
  return 12.0 * sum / count;
}

TEST(Rng, StreamsAndSeedsAreUncorrelated) {
  const int count = 20000;  // standard error 1 / sqrt(count) = 0.007
  EXPECT_NEAR(Correlation(Rng(5, "a"), Rng(5, "a"), count), 1.0, 0.03);
  EXPECT_NEAR(Correlation(Rng(5, "a"), Rng(5, "b"), count), 0.0, 0.03);
  EXPECT_NEAR(Correlation(Rng(5, "a"), Rng(6, "a"), count), 0.0, 0.03);
}

TEST(Rng, UniformHasItsMomentsAndRange) {
  Rng rng(3, "uniform");
  const int count = 100000;
  double sum = 0.0;
  double squares = 0.0;
  for (int i = 0; i < count; ++i) {
    const double x = rng.Uniform();
    ASSERT_GE(x, 0.0);
    ASSERT_LT(x, 1.0);
    sum += x;
    squares += x * x;
  }
  EXPECT_NEAR(sum / count, 0.5, 0.005);
  EXPECT_NEAR(squares / count, 1.0 / 3.0, 0.005);
  for (int i = 0; i < 1000; ++i) {
    const double x = rng.Uniform(-3.0, 5.0);
    ASSERT_GE(x, -3.0);
    ASSERT_LE(x, 5.0);
  }
}

TEST(Rng, NormalHasItsMoments) {
  Rng rng(4, "normal");
  const int count = 200000;
  std::array<double, 5> moments{};
  for (int i = 0; i < count; ++i) {
    const double x = rng.Normal();
    for (int k = 1; k <= 4; ++k) moments[k] += std::pow(x, k) / count;
  }
  EXPECT_NEAR(moments[1], 0.0, 0.01);
  EXPECT_NEAR(moments[2], 1.0, 0.02);
  EXPECT_NEAR(moments[3], 0.0, 0.05);
  EXPECT_NEAR(moments[4], 3.0, 0.15);
}

TEST(Rng, UniformIntCoversItsRangeEvenly) {
  Rng rng(6, "int");
  std::array<int, 7> counts{};
  const int draws = 70000;
  for (int i = 0; i < draws; ++i) ++counts[rng.UniformInt(counts.size())];
  for (const int count : counts) EXPECT_NEAR(count, draws / 7, 500);  // five standard errors
}

TEST(Rng, UniformIntAtItsLimits) {
  Rng rng(7, "limits");
  for (int i = 0; i < 100; ++i) EXPECT_EQ(rng.UniformInt(1), 0u);
  const std::uint64_t largest = ~std::uint64_t{0};
  for (int i = 0; i < 100; ++i) EXPECT_LT(rng.UniformInt(largest), largest);
  EXPECT_THROW(rng.UniformInt(0), Error);
}

}  // namespace
}  // namespace cvo
