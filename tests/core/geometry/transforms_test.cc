// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <numbers>

#include "core/base/error.h"
#include "core/base/rng.h"
#include "core/geometry/rigid_transform.h"
#include "tests/support/gradient_check.h"

namespace cvo::transforms_test {
namespace {

constexpr double kPi = std::numbers::pi;

Eigen::Vector3d RandomAxis(Rng& rng) {
  return Eigen::Vector3d(rng.Normal(), rng.Normal(), rng.Normal()).normalized();
}

// Angles around the transition from series to closed form, and near pi.
constexpr double kAngles[] = {0.0,    1e-300, 1e-12, 9.9e-7, 1.01e-6,   9.9e-6,     1.01e-5,
                              9.9e-5, 1e-3,   0.1,   1.0,    kPi - 0.1, kPi - 1e-6, kPi - 1e-9};

TEST(So3, LogUndoesExpFromZeroToPi) {
  Rng rng(1, "log");
  for (const double angle : kAngles) {
    const Eigen::Vector3d v = angle * RandomAxis(rng);
    const Eigen::Quaterniond q = ExpSo3(v);
    EXPECT_NEAR(q.norm(), 1.0, 1e-15);
    EXPECT_GE(q.w(), 0.0);
    EXPECT_LE((LogSo3(q) - v).norm(), 1e-15 + 4e-15 * angle) << angle;
    EXPECT_NEAR(RotationAngle(q), angle, 1e-14) << angle;
  }
}

TEST(So3, LogOfAHalfTurnIsEitherSolution) {
  const Eigen::Vector3d v = LogSo3(Eigen::Quaterniond(0, 0, 1, 0));
  EXPECT_NEAR(v.norm(), kPi, 1e-15);
  EXPECT_NEAR(std::abs(v.y()), kPi, 1e-15);
  EXPECT_NEAR(RotationAngle(Eigen::Quaterniond(0, 0, 1, 0)), kPi, 1e-15);
}

TEST(So3, BothQuaternionsOfARotationHaveTheSameLogAndAngle) {
  const Eigen::Quaterniond q = ExpSo3({0.3, -0.2, 0.9});
  const Eigen::Quaterniond opposite(-q.w(), -q.x(), -q.y(), -q.z());
  EXPECT_EQ(LogSo3(opposite), LogSo3(q));
  EXPECT_EQ(RotationAngle(opposite), RotationAngle(q));
}

TEST(So3, ExpTakesAnglesBeyondPi) {
  const Eigen::Vector3d axis(0, 0, 1);
  const Eigen::Vector3d v = LogSo3(ExpSo3((2.0 * kPi - 0.25) * axis));
  EXPECT_LT((v + 0.25 * axis).norm(), 1e-14);
}

TEST(So3, ExpIsTheMatrixExponential) {
  const Eigen::Vector3d v(0.4, -0.7, 0.2);
  Eigen::Matrix3d sum = Eigen::Matrix3d::Identity();
  Eigen::Matrix3d term = Eigen::Matrix3d::Identity();
  for (int k = 1; k < 30; ++k) {
    term = term * Skew(v) / k;
    sum += term;
  }
  EXPECT_LT((ExpSo3(v).toRotationMatrix() - sum).norm(), 1e-14);
}

TEST(GradientCheck, RejectsWrongEntriesShapesAndNaN) {
  const Eigen::Vector2d x(2.0, -3.0);
  const auto cubes = [](const Eigen::VectorXd& v) -> Eigen::VectorXd { return v.array().cube(); };
  const auto matches = [&](const Eigen::MatrixXd& J) { return test::JacobianMatches(cubes, x, J); };
  EXPECT_TRUE(matches(Eigen::Vector2d(12.0, 27.0).asDiagonal()));
  EXPECT_FALSE(matches(Eigen::Vector2d(12.0, 27.001).asDiagonal()));
  EXPECT_FALSE(matches(Eigen::MatrixXd::Zero(2, 3)));
  EXPECT_FALSE(matches(Eigen::Vector2d(12.0, std::nan("")).asDiagonal()));
}

// d/dd Log(Exp(v)^-1 Exp(v + d)) at d = 0.
TEST(So3, RightJacobianByNumericDifferentiation) {
  Rng rng(2, "jacobian");
  for (const double angle : {0.0, 9e-6, 1.1e-5, 1e-3, 0.5, 2.0, 3.1}) {
    const Eigen::Vector3d v = angle * RandomAxis(rng);
    const auto change = [&v](const Eigen::VectorXd& d) -> Eigen::VectorXd {
      return LogSo3(ExpSo3(v).conjugate() * ExpSo3(v + d.head<3>()));
    };
    const Eigen::Vector3d zero = Eigen::Vector3d::Zero();
    EXPECT_TRUE(test::JacobianMatches(change, zero, RightJacobianSo3(v), 1e-9)) << angle;
    const Eigen::Matrix3d product = RightJacobianSo3(v) * InverseRightJacobianSo3(v);
    EXPECT_LT((product - Eigen::Matrix3d::Identity()).norm(), 1e-10) << angle;
  }
}

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

TEST(RigidTransform, BlockIsQuaternionXyzwThenTranslation) {
  const RigidTransform a(Eigen::Quaterniond(0.5, -0.5, 0.1, 0.7), {1, 2, 3});
  EXPECT_NEAR(a.data()[3], 0.5, 1e-12);
  EXPECT_NEAR(a.data()[0], -0.5, 1e-12);
  EXPECT_EQ(a.data()[4], 1.0);
  EXPECT_EQ(a.data()[6], 3.0);
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
}  // namespace cvo::transforms_test
