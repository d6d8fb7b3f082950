// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/bodies/body_footprint.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/rng.h"
#include "core/bodies/body_direction.h"

namespace cvo::body_footprint_test {
namespace {

using Eigen::Vector3d;

const Vector3d kDown = Vector3d::UnitY();

// Returns points on the sides of a table of 1.2 x 0.7 x 0.5 m, rotated about the vertical.
Eigen::Matrix3Xd Table(double yaw_rad) {
  Rng rng(3, "table");
  const RigidTransform pose(ExpSo3({0.0, yaw_rad, 0.0}), Vector3d(0.5, 0.2, 4.0));
  Eigen::Matrix3Xd points(3, 600);
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    Vector3d p(rng.Uniform(-0.6, 0.6), rng.Uniform(-0.35, 0.35), rng.Uniform(-0.25, 0.25));
    const int axis = i % 2 == 0 ? 0 : 2;
    p[axis] = std::copysign(axis == 0 ? 0.6 : 0.25, p[axis]);
    points.col(i) = pose * p;
  }
  return points;
}

TEST(BodyFootprint, AlignsWithTheSideNearestToTheHeading) {
  for (const double yaw_rad : {0.0, 0.3, -0.5}) {
    const Eigen::Matrix3d axes = FootprintAxes(Table(yaw_rad), Vector3d::UnitX(), kDown, {});
    const Vector3d side(std::cos(yaw_rad), 0.0, -std::sin(yaw_rad));
    EXPECT_GT(axes.col(0).dot(side), std::cos(0.06)) << yaw_rad;  // half a step
    EXPECT_EQ(Vector3d(axes.col(1)), kDown);
    const Eigen::Matrix3d turned = FootprintAxes(Table(yaw_rad), Vector3d::UnitZ(), kDown, {});
    EXPECT_LT(std::abs(turned.col(0).dot(side)), std::sin(0.06)) << yaw_rad;
  }
}

TEST(BodyFootprint, UsesTheHeadingIfThereAreFewPoints) {
  const Eigen::Matrix3Xd few = Table(0.4).leftCols(10);
  EXPECT_EQ(FootprintAxes(few, Vector3d::UnitX(), kDown, {}), BoxAxes(Vector3d::UnitX(), kDown));
}

TEST(BodyFootprint, SidesReachToTheOutermostInliers) {
  Eigen::Matrix3Xd points = Table(0.0);
  points.col(7).setConstant(30.0);
  const LandmarkSides sides = SidesAlong(BoxAxes(Vector3d::UnitX(), kDown), points, {}, {});
  EXPECT_LT((sides.size_m - Vector3d(1.2, 0.7, 0.5)).cwiseAbs().maxCoeff(), 0.05);
}

TEST(BodyFootprint, ImagesCorrectTheSizeFromLandmarks) {
  const Vector3d told(2.0, 0.6, 0.4);
  EXPECT_EQ(WithPictures(told, {}, {}), told);
  const Vector3d sides = WithPictures(told, {.height_m = 0.8, .square_m = 1.0}, {});
  EXPECT_LT((sides - Vector3d(1.2, 0.8, 1.0 / 1.2)).norm(), 1e-12);
}

TEST(BodyFootprint, SidesOfABallAreItsDiameter) {
  // Landmarks are on the near side only, and a single image may show only part of the ball.
  const Vector3d told(0.5, 0.55, 0.3);
  EXPECT_EQ(SidesOfBall(told, {.height_m = 0.4, .square_m = 0.6}), Vector3d::Constant(0.6));
  EXPECT_EQ(SidesOfBall(told, {.height_m = 0.6, .square_m = 0.0}), Vector3d::Constant(0.6));
  EXPECT_EQ(SidesOfBall(told, {}), Vector3d::Constant(0.55));
}

TEST(BodyFootprint, MissingDepthIsAddedOnTheFarSide) {
  LandmarkSides sides{{-0.5, -0.3, 3.0}, {0.5, 0.3, 3.2}, {1.0, 0.6, 0.2}};
  const BoxShape shape{Eigen::Matrix3d::Identity(), {1.0, 0.6, 1.0}};
  EXPECT_LT(
      (CenterBehindNearSides(sides, shape, Vector3d::Zero()) - Vector3d(0.0, 0.0, 3.5)).norm(),
      1e-12);
  EXPECT_LT((CenterBehindNearSides(sides, shape, {0.0, 0.0, 9.0}) - Vector3d(0.0, 0.0, 2.7)).norm(),
            1e-12);
}

}  // namespace
}  // namespace cvo::body_footprint_test
