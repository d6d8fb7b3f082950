// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/rigid_transform.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <numbers>

#include "core/base/rng.h"
#include "tests/support/gradient_check.h"

namespace cvo {
namespace {

Eigen::Vector3d RandomVector(Rng& rng, double scale) {
  return {scale * rng.Normal(), scale * rng.Normal(), scale * rng.Normal()};
}

RigidTransform RandomTransform(Rng& rng) {
  return {ExpSo3(RandomVector(rng, 1.5)), RandomVector(rng, 10.0)};
}

void ExpectNear(const RigidTransform& a, const RigidTransform& b, double tolerance = 1e-12) {
  EXPECT_LT((a.Matrix() - b.Matrix()).norm(), tolerance) << a.Matrix() << "\n\n" << b.Matrix();
}

TEST(RigidTransform, GroupLaws) {
  Rng rng(1, "group");
  for (int i = 0; i < 50; ++i) {
    const RigidTransform a = RandomTransform(rng);
    const RigidTransform b = RandomTransform(rng);
    const RigidTransform c = RandomTransform(rng);
    ExpectNear(a * RigidTransform(), a);
    ExpectNear(RigidTransform() * a, a);
    ExpectNear(a * a.Inverse(), RigidTransform());
    ExpectNear(a.Inverse() * a, RigidTransform());
    ExpectNear((a * b) * c, a * (b * c), 1e-11);
    ExpectNear((a * b).Inverse(), b.Inverse() * a.Inverse(), 1e-11);
  }
}

TEST(RigidTransform, ActsOnPointsAsItsMatrix) {
  Rng rng(2, "points");
  const RigidTransform a = RandomTransform(rng);
  const RigidTransform b = RandomTransform(rng);
  const Eigen::Vector3d p = RandomVector(rng, 5.0);
  EXPECT_LT((a * p - (a.Matrix() * p.homogeneous()).head<3>()).norm(), 1e-12);
  EXPECT_LT(((a * b) * p - a * (b * p)).norm(), 1e-12);
}

// A rotation by 90 degrees about z, followed by a translation of one metre along x.
TEST(RigidTransform, HandComputed) {
  const double quarter = 0.5 * std::numbers::pi;
  const RigidTransform a(ExpSo3({0, 0, quarter}), {1, 0, 0});
  EXPECT_LT((a * Eigen::Vector3d(2, 0, 0) - Eigen::Vector3d(1, 2, 0)).norm(), 1e-15);
  EXPECT_LT((a.Inverse() * Eigen::Vector3d(1, 2, 0) - Eigen::Vector3d(2, 0, 0)).norm(), 1e-15);
}

TEST(RigidTransform, BlockIsQuaternionXyzwThenTranslation) {
  const RigidTransform a(Eigen::Quaterniond(0.5, -0.5, 0.1, 0.7), {1, 2, 3});
  EXPECT_NEAR(a.data()[3], 0.5, 1e-12);
  EXPECT_NEAR(a.data()[0], -0.5, 1e-12);
  EXPECT_EQ(a.data()[4], 1.0);
  EXPECT_EQ(a.data()[6], 3.0);
}

TEST(RigidTransform, NormalisesItsRotation) {
  const RigidTransform a(Eigen::Quaterniond(2, 0, 0, 2), Eigen::Vector3d::Zero());
  EXPECT_NEAR(a.rotation().norm(), 1.0, 1e-15);
}

TEST(RigidTransform, PlusAndMinusAreInverse) {
  Rng rng(3, "plus");
  for (int i = 0; i < 50; ++i) {
    const RigidTransform x = RandomTransform(rng);
    const RigidTransform y = RandomTransform(rng);
    ExpectNear(x.Plus(y.Minus(x)), y, 1e-11);
    Vector6d tangent;
    tangent << RandomVector(rng, 0.5), RandomVector(rng, 3.0);
    EXPECT_LT((x.Plus(tangent).Minus(x) - tangent).norm(), 1e-11);
    EXPECT_EQ(x.Minus(x).tail<3>(), Eigen::Vector3d::Zero());
  }
}

TEST(RigidTransform, PlusRotatesOnTheRightAndTranslatesInTheParentFrame) {
  const RigidTransform x(ExpSo3({0, 0, 0.5 * std::numbers::pi}), {1, 1, 1});
  Vector6d tangent;
  tangent << 0.3, 0, 0, 0.1, 0.2, 0.3;
  const RigidTransform y = x.Plus(tangent);
  EXPECT_LT((y.translation() - Eigen::Vector3d(1.1, 1.2, 1.3)).norm(), 1e-15);
  const Eigen::Matrix3d expected = x.RotationMatrix() * ExpSo3({0.3, 0, 0}).toRotationMatrix();
  EXPECT_LT((y.RotationMatrix() - expected).norm(), 1e-15);
}

// The derivatives of c = R^T (p - t) for this tangent, as given in METHOD.md 1.1.
TEST(RigidTransform, DerivativeOfAPointInTheCamera) {
  Rng rng(4, "derivative");
  const RigidTransform world_from_camera = RandomTransform(rng);
  const Eigen::Vector3d p_in_world = RandomVector(rng, 10.0);
  const Eigen::Vector3d p_in_camera = world_from_camera.Inverse() * p_in_world;
  const Eigen::Matrix3d camera_from_world = world_from_camera.RotationMatrix().transpose();
  Eigen::Matrix<double, 3, 6> J;
  J << Skew(p_in_camera), -camera_from_world;
  const auto transform = [&](const Eigen::VectorXd& tangent) -> Eigen::VectorXd {
    return world_from_camera.Plus(tangent).Inverse() * p_in_world;
  };
  EXPECT_TRUE(test::JacobianMatches(transform, Vector6d::Zero(), J, 1e-9));
}

}  // namespace
}  // namespace cvo
