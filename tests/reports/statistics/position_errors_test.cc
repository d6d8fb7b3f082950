// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/statistics/position_errors.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/base/error.h"
#include "core/base/rng.h"

namespace cvo::reports {
namespace {

using Position = std::array<double, 3>;
using Path = std::vector<Position>;

// Random positions, not centred at the origin, with a different spread along each axis.
Path Scattered(Rng& rng, int count) {
  Path path;
  for (int i = 0; i < count; ++i) {
    path.push_back({3.0 + 2.0 * rng.Normal(), -5.0 + rng.Normal(), 1.0 + 4.0 * rng.Normal()});
  }
  return path;
}

// Rotates a path about the unit vector `axis`, then translates it by `by`.
Path Moved(const Path& path, const Position& axis, double angle_rad, const Position& by) {
  const double c = std::cos(angle_rad);
  const double s = std::sin(angle_rad);
  Path moved;
  for (const Position& p : path) {
    const double along = axis[0] * p[0] + axis[1] * p[1] + axis[2] * p[2];
    Position& q = moved.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t l = (k + 1) % 3;
      const std::size_t m = (k + 2) % 3;
      q[k] = c * p[k] + (1.0 - c) * along * axis[k] + s * (axis[l] * p[m] - axis[m] * p[l]) + by[k];
    }
  }
  return moved;
}

Position RandomAxis(Rng& rng) {
  Position axis = {rng.Normal(), rng.Normal(), rng.Normal()};
  const double length = std::hypot(axis[0], axis[1], axis[2]);
  for (double& k : axis) k /= length;
  return axis;
}

TEST(AlignedErrors, VanishForRigidMotions) {
  Rng rng(1, "aligned");
  for (int trial = 0; trial < 50; ++trial) {
    const Path truth = Scattered(rng, 12);
    const double angle_rad = trial % 5 == 0 ? std::numbers::pi : rng.Uniform(-3.0, 3.0);
    const Path moved = Moved(truth, RandomAxis(rng), angle_rad, {7.0, -8.0, 9.0});
    for (const double error_m : AlignedErrors(moved, truth)) EXPECT_NEAR(error_m, 0.0, 1e-12);
  }
}

// The errors of a wrong estimate, too, do not depend on its choice of world frame.
TEST(AlignedErrors, DoNotDependOnTheWorldFrameOfTheEstimate) {
  Rng rng(3, "aligned");
  for (int trial = 0; trial < 20; ++trial) {
    const Path truth = Scattered(rng, 10);
    const Path estimate = Scattered(rng, 10);
    const std::vector<double> expected = AlignedErrors(estimate, truth);
    const Path moved = Moved(estimate, RandomAxis(rng), rng.Uniform(-3.0, 3.0), {4.0, 5.0, -6.0});
    const std::vector<double> found = AlignedErrors(moved, truth);
    ASSERT_EQ(found.size(), 10U);
    for (std::size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i], expected[i], 1e-10);
  }
}

// Three pairs of points on the axes, each axis stretched by its own factor: no rotation reduces the
// errors, and each point is off by the stretch of its axis.
TEST(AlignedErrors, OfStretchedAxes) {
  const Path truth = {{1, 0, 0}, {-1, 0, 0}, {0, 2, 0}, {0, -2, 0}, {0, 0, 3}, {0, 0, -3}};
  Path stretched = truth;
  for (Position& p : stretched) p = {1.1 * p[0] + 4.0, 1.2 * p[1] - 5.0, 0.9 * p[2] + 6.0};
  const std::vector<double> errors_m = AlignedErrors(stretched, truth);
  const std::array<double, 6> expected_m = {0.1, 0.1, 0.4, 0.4, 0.3, 0.3};
  for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(errors_m[i], expected_m[i], 1e-12);
}

TEST(AlignedErrors, OfOneAndOfNoPosition) {
  EXPECT_NEAR(AlignedErrors({{1.0, 2.0, 3.0}}, {{-4.0, 5.0, 6.0}}).at(0), 0.0, 1e-12);
  EXPECT_TRUE(AlignedErrors({}, {}).empty());
  EXPECT_THROW(AlignedErrors({{1.0, 2.0, 3.0}}, {}), Error);
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

TEST(CommonFrames, IncludeTheFirstAndTheLast) {
  const FrameErrors a = {{0, 2}, {3.0, 4.0}};
  const FrameErrors b = {{0, 1, 2}, {1.0, 9.0, 7.0}};
  const auto both = CommonRootMeanSquares(a, b);
  EXPECT_DOUBLE_EQ(both->first, std::sqrt(12.5));
  EXPECT_DOUBLE_EQ(both->second, 5.0);
  EXPECT_DOUBLE_EQ(CommonRootMeanSquares({{4}, {2.0}}, {{4}, {3.0}})->second, 3.0);
}

}  // namespace
}  // namespace cvo::reports
