// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <numbers>

#include "core/base/rng.h"
#include "core/geometry/rigid_transform.h"
#include "tests/support/gradient_check.h"

namespace cvo {
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

TEST(So3, SkewIsTheCrossProduct) {
  const Eigen::Vector3d a(1, 2, 3);
  const Eigen::Vector3d b(-4, 5, 6);
  EXPECT_EQ(Skew(a) * b, a.cross(b));
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

// d/dd Log(Exp(v) Exp(d)) at d = 0.
TEST(So3, InverseRightJacobianByNumericDifferentiation) {
  const Eigen::Vector3d v(0.5, -1.0, 0.8);
  const auto log_of_product = [&v](const Eigen::VectorXd& d) -> Eigen::VectorXd {
    return LogSo3(ExpSo3(v) * ExpSo3(d.head<3>()));
  };
  const Eigen::Vector3d zero = Eigen::Vector3d::Zero();
  EXPECT_TRUE(test::JacobianMatches(log_of_product, zero, InverseRightJacobianSo3(v), 1e-9));
}

TEST(So3, JacobiansAreContinuousBetweenSeriesAndClosedForm) {
  const Eigen::Vector3d axis = Eigen::Vector3d(1, 2, -1).normalized();
  const Eigen::Vector3d below = 0.9999999e-5 * axis;
  const Eigen::Vector3d above = 1.0000001e-5 * axis;
  EXPECT_LT((RightJacobianSo3(below) - RightJacobianSo3(above)).norm(), 1e-11);
  EXPECT_LT((InverseRightJacobianSo3(below) - InverseRightJacobianSo3(above)).norm(), 1e-11);
}

}  // namespace
}  // namespace cvo
