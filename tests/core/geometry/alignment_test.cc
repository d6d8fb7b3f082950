// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <Eigen/LU>

#include "core/base/error.h"
#include "core/base/rng.h"
#include "core/geometry/rigid_transform.h"

namespace cvo {
namespace {

Eigen::Matrix3Xd RandomPoints(Rng& rng, int count) {
  Eigen::Matrix3Xd points(3, count);
  for (Eigen::Index i = 0; i < points.size(); ++i) points.data()[i] = 5.0 * rng.Normal();
  return points;
}

const RigidTransform kTruth(ExpSo3({0.4, -2.0, 1.1}), {3.0, -20.0, 7.0});

Eigen::Matrix3Xd Moved(const RigidTransform& transform, const Eigen::Matrix3Xd& points) {
  Eigen::Matrix3Xd moved(3, points.cols());
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    moved.col(i) = transform * Eigen::Vector3d(points.col(i));
  }
  return moved;
}

bool IsRotation(const Eigen::Matrix3d& R) {
  return (R * R.transpose() - Eigen::Matrix3d::Identity()).norm() < 1e-12 &&
         std::abs(R.determinant() - 1.0) < 1e-12;
}

TEST(NearestRotation, KeepsARotation) {
  const Eigen::Matrix3d R = kTruth.RotationMatrix();
  EXPECT_LT((NearestRotation(R) - R).norm(), 1e-14);
  EXPECT_LT((NearestRotation(7.0 * R) - R).norm(), 1e-14);
}

TEST(NearestRotation, IsNearerThanPerturbedRotations) {
  Rng rng(1, "nearest");
  for (int i = 0; i < 20; ++i) {
    const Eigen::Matrix3d M = RandomPoints(rng, 3);  // half of them with a negative determinant
    const Eigen::Matrix3d R = NearestRotation(M);
    ASSERT_TRUE(IsRotation(R));
    for (int k = 0; k < 20; ++k) {
      const Eigen::Vector3d v = 0.1 * RandomPoints(rng, 1).col(0);
      EXPECT_LE((M - R).norm(), (M - R * ExpSo3(v).toRotationMatrix()).norm() + 1e-12);
    }
  }
}

TEST(NearestRotation, GivesARotationForSingularMatrices) {
  EXPECT_TRUE(IsRotation(NearestRotation(Eigen::Matrix3d::Zero())));
  EXPECT_TRUE(IsRotation(NearestRotation(Eigen::Vector3d(1, 0, 0).asDiagonal())));
  EXPECT_TRUE(IsRotation(NearestRotation(-Eigen::Matrix3d::Identity())));
}

TEST(AlignPoints, IsExactWithoutNoise) {
  Rng rng(2, "align");
  const Eigen::Matrix3Xd points = RandomPoints(rng, 20);
  const RigidTransform found = AlignPoints(points, Moved(kTruth, points));
  EXPECT_LT((found.Matrix() - kTruth.Matrix()).norm(), 1e-12);
}

TEST(AlignPoints, IsExactOnAPlane) {
  Rng rng(3, "plane");
  Eigen::Matrix3Xd points = RandomPoints(rng, 20);
  points.row(1).setConstant(1.5);
  const RigidTransform found = AlignPoints(points, Moved(kTruth, points));
  EXPECT_LT((found.Matrix() - kTruth.Matrix()).norm(), 1e-12);
}

// The rotation about the line is undetermined, so only the points can be compared.
TEST(AlignPoints, MapsPointsOfALineAndSinglePoints) {
  Eigen::Matrix3Xd line(3, 10);
  for (int i = 0; i < 10; ++i)
    line.col(i) = Eigen::Vector3d(1, 2, 3) + i * Eigen::Vector3d(1, 1, 0);
  for (const Eigen::Index count : {10, 2, 1}) {
    const Eigen::Matrix3Xd points = line.leftCols(count);
    const RigidTransform found = AlignPoints(points, Moved(kTruth, points));
    EXPECT_TRUE(IsRotation(found.RotationMatrix()));
    EXPECT_LT((Moved(found, points) - Moved(kTruth, points)).norm(), 1e-10) << count;
  }
}

TEST(AlignPoints, NeverReflects) {
  Rng rng(4, "mirror");
  const Eigen::Matrix3Xd points = RandomPoints(rng, 10);
  const RigidTransform found = AlignPoints(points, Eigen::Matrix3Xd(-points));
  EXPECT_TRUE(IsRotation(found.RotationMatrix()));
}

TEST(AlignPoints, MinimisesTheSquaredError) {
  Rng rng(5, "noise");
  const Eigen::Matrix3Xd from = RandomPoints(rng, 15);
  const Eigen::Matrix3Xd to = Moved(kTruth, from) + 0.1 * RandomPoints(rng, 15);
  const RigidTransform best = AlignPoints(from, to);
  for (int i = 0; i < 50; ++i) {
    Vector6d tangent;
    tangent << 0.02 * RandomPoints(rng, 1), 0.02 * RandomPoints(rng, 1);
    EXPECT_LT((to - Moved(best, from)).norm(), (to - Moved(best.Plus(tangent), from)).norm());
  }
}

TEST(AlignPoints, RefusesEmptyAndUnpairedInput) {
  EXPECT_THROW(AlignPoints(Eigen::Matrix3Xd(3, 0), Eigen::Matrix3Xd(3, 0)), Error);
  EXPECT_THROW(AlignPoints(Eigen::Matrix3Xd::Zero(3, 2), Eigen::Matrix3Xd::Zero(3, 3)), Error);
}

}  // namespace
}  // namespace cvo
