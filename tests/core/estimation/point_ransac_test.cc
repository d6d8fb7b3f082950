// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/estimation/point_ransac.h"

#include <gtest/gtest.h>

namespace cvo::point_ransac_test {
namespace {

const RigidTransform kMotion(ExpSo3({0.3, -0.5, 0.2}), Eigen::Vector3d(2.0, -1.0, 4.0));

Eigen::Matrix3Xd RandomPoints(Rng& rng, int count) {
  return Eigen::Matrix3Xd::NullaryExpr(3, count, [&] { return rng.Normal(); });
}

Eigen::Matrix3Xd Moved(const Eigen::Matrix3Xd& points) {
  Eigen::Matrix3Xd moved = points;
  for (Eigen::Index i = 0; i < moved.cols(); ++i) moved.col(i) = kMotion * moved.col(i).eval();
  return moved;
}

double Error(const std::optional<RigidTransform>& found) {
  return found ? kMotion.Minus(*found).norm() : 1e9;
}

TEST(AlignPointsRansac, FindsTheCommonMotionAmongOutliers) {
  Rng rng(1, "points");
  const Eigen::Matrix3Xd from = RandomPoints(rng, 40);
  Eigen::Matrix3Xd to = Moved(from);
  to.leftCols(20) = 5.0 * RandomPoints(rng, 20);
  EXPECT_LT(Error(AlignPointsRansac(from, to, 0.01, 20, 200, rng)), 1e-9);
  EXPECT_FALSE(AlignPointsRansac(from, to, 0.01, 21, 200, rng)) << "twenty agree";
}

TEST(AlignPointsRansac, ThreePointsAreEnoughAndFewerAreNot) {
  Rng rng(2, "points");
  const Eigen::Matrix3Xd from = RandomPoints(rng, 3);
  EXPECT_LT(Error(AlignPointsRansac(from, Moved(from), 1e-6, 3, 50, rng)), 1e-9);
  EXPECT_FALSE(AlignPointsRansac(from, Moved(from), 1e-6, 4, 50, rng));
  EXPECT_FALSE(AlignPointsRansac(from, Moved(from), 1e-6, 3, 0, rng)) << "nothing is tried";
  const Eigen::Matrix3Xd two = from.leftCols(2);
  EXPECT_FALSE(AlignPointsRansac(two, Moved(two), 1e-6, 2, 50, rng));
}

// With three points and one iteration, either three different points are drawn or nothing is found.
// Two points alone would leave the rotation about their line undetermined.
TEST(AlignPointsRansac, SamplesThreeDistinctPoints) {
  Rng rng(3, "points");
  const Eigen::Matrix3Xd from = RandomPoints(rng, 3);
  int found = 0;
  constexpr int kTrials = 300;
  for (int trial = 0; trial < kTrials; ++trial) {
    const auto motion = AlignPointsRansac(from, Moved(from), 1e-6, 2, 1, rng);
    if (!motion) continue;
    EXPECT_LT(Error(motion), 1e-9);
    ++found;
  }
  EXPECT_NEAR(found, kTrials * 6.0 / 27.0, 25.0) << "of 27 draws, six are of three points";
}

// The fifth point is off by 1 m.
TEST(AlignPointsRansac, AllPointsWithinTheDistanceHaveEqualWeight) {
  Eigen::Matrix3Xd from(3, 5);
  from << 0, 4, 0, 4, 0,  //
      0, 0, 4, 4, 0,      //
      0, 0, 0, 0, 3;
  Eigen::Matrix3Xd to = from;
  to(2, 4) += 1.0;
  Rng rng(4, "points");
  const auto near = AlignPointsRansac(from, to, 1.001, 5, 300, rng);
  ASSERT_TRUE(near);
  EXPECT_GT(near->Minus(RigidTransform()).norm(), 0.05) << "the fifth point takes part";
  const auto far = AlignPointsRansac(from, to, 0.3, 4, 300, rng);
  ASSERT_TRUE(far);
  EXPECT_LT(far->Minus(RigidTransform()).norm(), 1e-9);
}

}  // namespace
}  // namespace cvo::point_ransac_test
