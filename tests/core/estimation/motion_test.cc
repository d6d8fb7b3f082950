// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <array>

#include "core/base/error.h"
#include "core/base/rng.h"
#include "core/estimation/motion_extrapolation.h"
#include "core/solvers/motion_prior.h"
#include "tests/support/gradient_check.h"

namespace cvo::motion_test {
namespace {

Eigen::Vector3d RandomVector(Rng& rng) { return {rng.Normal(), rng.Normal(), rng.Normal()}; }

TEST(MotionPrior, SquaredNormIsTheMahalanobisDistance) {
  Rng rng(2, "motion");
  for (const double dt : {0.01, 0.1, 1.0, 3.5}) {
    const double q = 0.7;
    Eigen::Matrix<double, 4, 3> state;  // position and velocity of one frame and the next
    for (double& value : state.reshaped()) value = rng.Normal();
    const Eigen::Vector3d t = state.row(0);
    const Eigen::Vector3d v = state.row(1);
    const Eigen::Vector3d next_t = state.row(2);
    const Eigen::Vector3d next_v = state.row(3);
    Vector6d e;
    e << next_t - t - dt * v, next_v - v;
    Matrix6d Q;
    const Eigen::Matrix3d I = q * Eigen::Matrix3d::Identity();
    Q << dt * dt * dt / 3.0 * I, dt * dt / 2.0 * I, dt * dt / 2.0 * I, dt * I;
    const double expected = e.dot(Q.inverse() * e);
    const MotionPriorFactors factors = WhitenMotionPrior(q, dt);
    const Vector6d r = EvaluateMotionPrior(factors, t, v, next_t, next_v);
    EXPECT_NEAR(r.squaredNorm() / expected, 1.0, 1e-9);
    // The residual is linear.
    const Eigen::Matrix<double, 2, 3> by_axis = MotionPriorAxisJacobian(factors) * state;
    EXPECT_LT((by_axis.row(0).transpose() - r.head<3>()).norm(), 1e-9 * r.norm());
    EXPECT_LT((by_axis.row(1).transpose() - r.tail<3>()).norm(), 1e-9 * r.norm());
  }
}

// Evaluates the prior for consecutive orientations, perturbed by rotations in world axes.
Eigen::Vector3d TurnResidual(const Eigen::VectorXd& turns, const std::array<double, 2>& dt_s,
                             const std::array<Eigen::Quaterniond, 3>& orientations) {
  std::array<Eigen::Quaterniond, 3> turned;
  for (int i = 0; i < 3; ++i) turned[i] = ExpSo3(turns.segment<3>(3 * i)) * orientations[i];
  return EvaluateTurnPrior(0.3, dt_s, turned).r;
}

TEST(TurnPrior, IsZeroAtAConstantRateForAnySteps) {
  Rng rng(4, "motion");
  const Eigen::Vector3d rate = 0.5 * RandomVector(rng);
  const Eigen::Quaterniond first = ExpSo3(RandomVector(rng));
  const std::array<Eigen::Quaterniond, 3> orientations = {first, ExpSo3(0.1 * rate) * first,
                                                          ExpSo3(0.4 * rate) * first};
  EXPECT_LT(EvaluateTurnPrior(0.3, {0.1, 0.3}, orientations).r.norm(), 1e-12);
}

TEST(TurnPrior, MatchesHandComputedValue) {
  // No rotation in the first step of 1 s, 0.2 rad in the second, at q = 0.5: the variance is 1/3.
  const Eigen::Quaterniond still = Eigen::Quaterniond::Identity();
  const TurnPrior prior = EvaluateTurnPrior(0.5, {1.0, 1.0}, {still, still, ExpSo3({0, 0.2, 0})});
  EXPECT_NEAR(prior.r.squaredNorm(), 0.04 * 3.0, 1e-12);
}

TEST(TurnPrior, JacobiansMatchDifferences) {
  Rng rng(5, "motion");
  for (const double size : {0.0, 0.01, 1.0}) {
    const Eigen::Quaterniond first = ExpSo3(RandomVector(rng));
    const Eigen::Quaterniond second = ExpSo3(size * RandomVector(rng).normalized()) * first;
    const Eigen::Quaterniond third = ExpSo3(size * RandomVector(rng).normalized()) * second;
    const std::array<double, 2> dt_s = {0.1, 0.25};
    const TurnPrior prior = EvaluateTurnPrior(0.3, dt_s, {first, second, third});
    Eigen::MatrixXd J(3, 9);
    J << prior.J[0], prior.J[1], prior.J[2];
    const auto residual = [&](const Eigen::VectorXd& turns) -> Eigen::VectorXd {
      return TurnResidual(turns, dt_s, {first, second, third});
    };
    EXPECT_TRUE(test::JacobianMatches(residual, Eigen::VectorXd::Zero(9), J));
  }
}

TEST(MotionPrior, FrameUnitsAgreeWithSecondsAtOneFramePerSecond) {
  const MotionPriorOptions options;
  EXPECT_DOUBLE_EQ(WhiteNoiseOnAccelerationFrameUnits::PowerDensity(options, 1.0),
                   options.q_m2_frame3);
  EXPECT_NEAR(WhiteNoiseOnAccelerationFrameUnits::PowerDensity(options, 0.1), 10.0, 1e-9);
  EXPECT_EQ(WhiteNoiseOnAcceleration::PowerDensity(options, 0.1), options.q_m2_s3);
}

// A body that rotates about a fixed axis at 0.8 rad/s and moves at constant velocity.
MotionState TurningBody(double time_s) {
  const Eigen::Vector3d axis = Eigen::Vector3d(1.0, 2.0, -0.5).normalized();
  const Eigen::Vector3d velocity(1.0, 0.2, -3.0);
  return {time_s,
          {ExpSo3({0.3, 0.1, 0.2}) * ExpSo3(0.8 * time_s * axis),
           Eigen::Vector3d(4.0, 1.0, 20.0) + time_s * velocity},
          velocity};
}

TEST(Extrapolate, FollowsConstantTranslationAndRotation) {
  const std::array<MotionState, 3> states = {TurningBody(0.0), TurningBody(0.1), TurningBody(0.3)};
  for (const double time_s : {0.35, 0.4, 1.0}) {
    const PredictedMotion predicted =
        Extrapolate<WhiteNoiseOnAcceleration, ConstantMotion>({}, states, time_s);
    const MotionState truth = TurningBody(time_s);
    EXPECT_LT(predicted.state.world_from_object.Minus(truth.world_from_object).norm(), 1e-9);
  }
}

TEST(Extrapolate, AcrossAGapTheCentreOfARollingBodyGoesStraightOn) {
  const Eigen::Vector3d center_in_object(0.3, 0.1, 0.0);
  const Eigen::Vector3d turn_rad_s(0.0, 0.0, 2.5);
  const Eigen::Vector3d speed_m_s(0.45, 0.0, 0.1);
  const auto state_at = [&](double time_s) {
    const Eigen::Quaterniond rotation = ExpSo3(turn_rad_s * time_s);
    const Eigen::Vector3d lever = rotation * center_in_object;
    return MotionState{time_s,
                       {rotation, Eigen::Vector3d(time_s * speed_m_s - lever)},
                       speed_m_s - turn_rad_s.cross(lever)};
  };
  std::vector<MotionState> states;
  for (int i = 0; i < 12; ++i) states.push_back(state_at(0.1 * i));
  const auto off_center_m = [&](double time_s) {
    const auto predicted =
        Extrapolate<WhiteNoiseOnAcceleration, ConstantMotion>({}, states, time_s);
    EXPECT_LT(RotationAngle(predicted.state.world_from_object.rotation() *
                            state_at(time_s).world_from_object.rotation().conjugate()),
              1e-6);
    return (predicted.state.world_from_object * center_in_object - time_s * speed_m_s).norm();
  };
  EXPECT_LT(off_center_m(2.1), 0.06);  // with the last velocity of the origin: 0.5 m
  states.back().velocity_m_s.setZero();
  EXPECT_LT(off_center_m(2.1), 0.06);
  EXPECT_GT(off_center_m(1.2), 0.03) << "the next frame follows the last velocity";
  states.resize(3);
  states.back().velocity_m_s.setZero();
  EXPECT_GT(off_center_m(1.2), 0.3) << "three states do not tell";
}

TEST(Extrapolate, VarianceGrowsWithNoiseAndVelocity) {
  const std::array<MotionState, 1> states = {TurningBody(0.0)};
  const auto predicted =
      Extrapolate<WhiteNoiseOnAcceleration, HeldRotation>({.q_m2_s3 = 3.0}, states, 2.0);
  for (const auto& [speed, variance] : {std::pair(2.0, 24.0), {1.0, 12.0}, {0.5, 9.0}}) {
    EXPECT_DOUBLE_EQ(AddedVariance(predicted.power_density_m2_s3, speed, 2.0), variance);
  }
}

TEST(Extrapolate, RefusesTheTimeOfTheLastStateAndBefore) {
  const std::array<MotionState, 1> states = {TurningBody(0.1)};
  for (const double time_s : {0.1, 0.05}) {
    EXPECT_THROW((Extrapolate<NoMotionPrior, HeldRotation>({}, states, time_s)), Error);
  }
}

}  // namespace
}  // namespace cvo::motion_test
