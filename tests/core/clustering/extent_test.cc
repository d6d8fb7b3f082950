// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>

#include "core/base/rng.h"
#include "core/clustering/depth_mode.h"
#include "core/clustering/point_extent.h"
#include "tests/support/error_message.h"

namespace cvo::extent_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const Eigen::Vector3d kCenter(3.0, -1.0, 12.0);

// Returns random points in a solid box with the given half sizes along the columns of `axes`.
Eigen::Matrix3Xd Solid(const Eigen::Vector3d& half_size_m, const Eigen::Matrix3d& axes, int count,
                       Rng& rng) {
  Eigen::Matrix3Xd points(3, count);
  for (int i = 0; i < count; ++i) {
    const Eigen::Vector3d unit(rng.Uniform(-1, 1), rng.Uniform(-1, 1), rng.Uniform(-1, 1));
    points.col(i) = kCenter + axes * half_size_m.cwiseProduct(unit);
  }
  return points;
}

Eigen::Matrix3d Turned() { return ExpSo3({0.3, 0.5, -0.2}).toRotationMatrix(); }

TEST(ExtentAlong, IsTwoFifthsOfTheHalfSizeOfASolid) {
  Rng rng(1, "extent");
  const Eigen::Vector3d half_size_m(2.0, 1.0, 0.5);
  const PointExtent extent = ExtentAlong(Turned(), Solid(half_size_m, Turned(), 20000, rng), {});
  EXPECT_TRUE(extent.half_size_m.isApprox(0.4 * half_size_m, 0.02)) << extent.half_size_m;
  EXPECT_LT((extent.center - kCenter).norm(), 0.04);
}

TEST(ExtentAlong, OutliersShiftPercentilesOnlyByTheirShare) {
  Rng rng(2, "extent");
  Eigen::Matrix3Xd points = Solid(Eigen::Vector3d::Ones(), Eigen::Matrix3d::Identity(), 20000, rng);
  points.leftCols(2000).row(2).array() += 100.0;
  const PointExtent extent = ExtentAlong(Eigen::Matrix3d::Identity(), points, {});
  // The 30th and 70th percentiles of all points are the 33.3rd and 77.8th of the inliers.
  EXPECT_NEAR(extent.center.z(), kCenter.z() + 1.0 / 9.0, 0.03);
  EXPECT_NEAR(extent.half_size_m.z(), 4.0 / 9.0, 0.03);
}

TEST(ExtentAlong, InterpolatesPercentiles) {
  Eigen::Matrix3Xd points = Eigen::Matrix3Xd::Zero(3, 3);
  points.row(0) << 4.0, 0.0, 1.0;  // 30th and 70th percentiles: 0.6 and 2.2
  const PointExtent extent =
      ExtentAlong(Eigen::Matrix3d::Identity(), points, ExtentOptions{.min_half_size_m = 0.2});
  EXPECT_TRUE(extent.center.isApprox(Eigen::Vector3d(1.4, 0.0, 0.0)));
  EXPECT_TRUE(extent.half_size_m.isApprox(Eigen::Vector3d(0.8, 0.2, 0.2)));
}

TEST(ExtentAlong, NeedsAPoint) {
  EXPECT_THAT(ErrorMessage([] { ExtentAlong(Eigen::Matrix3d::Identity(), {}, {}); }),
              HasSubstr("no points"));
  EXPECT_THAT(ErrorMessage([] { PrincipalAxes({}, {}); }), HasSubstr("no points"));
}

TEST(PrincipalAxes, AgreeWithTheAxesOfTheBody) {
  Rng rng(3, "extent");
  const RigidTransform frame = PrincipalAxes(Solid({2.0, 1.0, 0.5}, Turned(), 2000, rng), {});
  EXPECT_LT((frame.translation() - kCenter).norm(), 0.15);
  const Eigen::Matrix3d axes = frame.RotationMatrix();
  EXPECT_NEAR(axes.determinant(), 1.0, 1e-9);
  const Eigen::Matrix3d cosines = (Turned().transpose() * axes).cwiseAbs();
  EXPECT_GT(cosines.diagonal().minCoeff(), std::cos(0.05));
  EXPECT_GT(axes.col(0).cwiseAbs().maxCoeff(), 0.0);
}

TEST(PrincipalAxes, DoNotDependOnPointOrderOrReflection) {
  Rng rng(4, "extent");
  const Eigen::Matrix3Xd points = Solid({2.0, 1.0, 0.5}, Turned(), 200, rng);
  const RigidTransform frame = PrincipalAxes(points, {});
  const RigidTransform reversed = PrincipalAxes(points.rowwise().reverse(), {});
  EXPECT_LT(frame.Minus(reversed).norm(), 1e-9);
  // Point reflection preserves the axes of the body; the largest component of each is positive.
  const RigidTransform mirrored = PrincipalAxes(-points, {});
  EXPECT_TRUE(mirrored.RotationMatrix().isApprox(frame.RotationMatrix(), 1e-9));
  for (int axis = 0; axis < 2; ++axis) {
    const Eigen::Vector3d direction = frame.RotationMatrix().col(axis);
    EXPECT_EQ(direction.maxCoeff(), direction.cwiseAbs().maxCoeff());
  }
}

TEST(PrincipalAxes, AreNotTurnedByOutliers) {
  Rng rng(5, "extent");
  Eigen::Matrix3Xd points = Solid({2.0, 1.0, 0.5}, Eigen::Matrix3d::Identity(), 2000, rng);
  points.leftCols(100).colwise() += Eigen::Vector3d(20.0, 30.0, 40.0);
  const RigidTransform frame = PrincipalAxes(points, {});
  EXPECT_LT(RotationAngle(frame.rotation()), 0.1);
}

TEST(PrincipalAxes, FallBackToTheCameraForAmbiguousShapes) {
  Rng rng(6, "extent");
  const auto angle = [](const Eigen::Matrix3Xd& points) {
    return RotationAngle(PrincipalAxes(points, {}).rotation());
  };
  EXPECT_EQ(angle(Solid(Eigen::Vector3d::Ones(), Turned(), 500, rng)), 0.0);
  EXPECT_EQ(angle(Solid({2.0, 0.5, 0.5}, Turned(), 500, rng)), 0.0);
  EXPECT_EQ(angle(Solid({2.0, 0.0, 0.0}, Turned(), 500, rng)), 0.0);  // a line
  EXPECT_EQ(angle(kCenter), 0.0);
  EXPECT_EQ(angle(Eigen::Matrix3Xd(kCenter.replicate(1, 5))), 0.0);
}

TEST(PrincipalAxes, IncludeTheNormalOfAFlatBody) {
  Rng rng(7, "extent");
  const RigidTransform frame = PrincipalAxes(Solid({2.0, 1.0, 0.0}, Turned(), 500, rng), {});
  EXPECT_NEAR(std::abs(Turned().col(2).dot(frame.RotationMatrix().col(2))), 1.0, 1e-6);
}

std::vector<double> Spread(double from, double to, int count) {
  std::vector<double> depths;
  for (int i = 0; i < count; ++i) depths.push_back(from + (to - from) * (i + 0.5) / count);
  return depths;
}

std::vector<double> Joined(std::vector<double> first, const std::vector<double>& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

std::vector<int> FirstIndices(int count) {
  std::vector<int> indices(static_cast<std::size_t>(count));
  std::iota(indices.begin(), indices.end(), 0);
  return indices;
}

std::vector<int> Nearest(const std::vector<double>& depths_m, double angular_size,
                         const ExtentOptions& options) {
  const auto modes = DepthModes(depths_m, angular_size, options);
  return modes.empty() ? std::vector<int>() : modes.front();
}

constexpr double kCarAngle = 0.15;  // 3 m at 20 m

TEST(DepthModes, FindsTheForegroundInABoxWithHalfBackground) {
  const std::vector<double> depths = Joined(Spread(19, 21, 20), Spread(28, 60, 20));
  EXPECT_EQ(Nearest(depths, kCarAngle, {}), FirstIndices(20));
  // A wall is denser than the body in front of it.
  EXPECT_EQ(Nearest(Joined(Spread(19, 21, 20), Spread(28, 28.1, 30)), kCarAngle, {}),
            FirstIndices(20));
}

TEST(DepthModes, AreOrderedByDepth) {
  const auto modes = DepthModes(Joined(Spread(28, 28.1, 5), Spread(19, 21, 20)), kCarAngle, {});
  ASSERT_THAT(modes, ::testing::SizeIs(2));
  EXPECT_THAT(modes[0], ::testing::SizeIs(20));
  EXPECT_EQ(modes[1], FirstIndices(5));
}

TEST(DepthModes, IgnoresAFewNearerPoints) {
  const std::vector<double> near = {5.0, 5.1, 5.2, 9.0, 14.0};
  std::vector<int> car = FirstIndices(20);
  EXPECT_EQ(Nearest(Joined(Joined(Spread(19, 21, 20), Spread(30, 40, 20)), near), kCarAngle, {}),
            car);
}

TEST(DepthModes, ExtendFromTheirPeakNotFromAStrayPoint) {
  // Isolated points lie in front of the car and between the car and a wall.
  const std::vector<double> links = {17.9, 22, 23, 24, 25, 26, 27};
  const std::vector<double> depths = Joined(Joined(Spread(19, 21, 20), links), Spread(28, 29, 20));
  EXPECT_EQ(Nearest(depths, kCarAngle, {}), FirstIndices(20));
}

TEST(DepthModes, IncludesEverythingWithoutBackground) {
  EXPECT_EQ(Nearest(Spread(2.8, 3.3, 30), 0.2, {}), FirstIndices(30));
  EXPECT_EQ(Nearest(std::vector<double>(8, 4.0), 0.2, {}), FirstIndices(8));
}

TEST(DepthModes, WideBodiesMayBeDeep) {
  // A lorry that fills half the image is one body; at a smaller angular size, the same depths are
  // two bodies.
  const std::vector<double> depths = Joined(Spread(12, 15, 15), Spread(17.5, 21, 15));
  EXPECT_EQ(Nearest(depths, 0.7, {}), FirstIndices(30));
  EXPECT_EQ(Nearest(depths, 0.1, {}), FirstIndices(15));
}

TEST(DepthModes, IsEmptyWithTooFewPoints) {
  EXPECT_THAT(Nearest({}, kCarAngle, {}), IsEmpty());
  EXPECT_THAT(Nearest(Spread(19, 21, 4), kCarAngle, {}), IsEmpty());
  EXPECT_THAT(Nearest(Spread(19, 21, 4), kCarAngle, ExtentOptions{.mode_min_points = 4}),
              ElementsAre(0, 1, 2, 3));
  // Scattered points do not form a body.
  EXPECT_THAT(Nearest({1, 2, 4, 8, 16, 32, 64}, kCarAngle, {}), IsEmpty());
}

TEST(DepthModes, IgnoresInvalidDepths) {
  const double nan = std::nan("");
  const double inf = std::numeric_limits<double>::infinity();
  const std::vector<double> depths = {-1, 5.0, nan, 5.1, 0, 5.2, inf, 5.3, 5.4};
  EXPECT_THAT(Nearest(depths, kCarAngle, {}), ElementsAre(1, 3, 5, 7, 8));
}

// Depths with stereo noise, as of cars seen from behind and of furniture in front of a wall.
TEST(DepthModes, FindsTheForegroundInNoise) {
  Rng rng(8, "mode");
  for (const double z : {3.0, 8.0, 20.0, 40.0}) {
    double found = 0.0;
    double wrong = 0.0;
    for (int trial = 0; trial < 100; ++trial) {
      std::vector<double> depths;
      for (int i = 0; i < 30; ++i) {
        const double depth = i < 15 ? z * rng.Uniform(0.95, 1.05) : z * rng.Uniform(1.35, 2.5);
        depths.push_back(350.0 / (350.0 / depth + 0.3 * rng.Normal()));
      }
      for (const int i : Nearest(depths, 0.12, {})) (i < 15 ? found : wrong) += 1.0;
    }
    EXPECT_GT(found / 1500.0, 0.9) << z;
    EXPECT_LT(wrong / found, 0.03) << z;
  }
}

}  // namespace
}  // namespace cvo::extent_test
