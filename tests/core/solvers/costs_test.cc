// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include "core/base/rng.h"
#include "core/ceres/ceres_solvers.h"
#include "core/solvers/reprojection_cost.h"
#include "tests/support/gradient_check.h"

namespace cvo::costs_test {
namespace {

using ceres_costs::PoseManifold;
using ceres_costs::PriorCost;
using ceres_costs::ReprojectionCost;

const StereoCamera kCamera = {.fx = 700,
                              .fy = 690,
                              .cx = 600,
                              .cy = 180,
                              .baseline_m = 0.54,
                              .width_px = 1242,
                              .height_px = 375,
                              .right_shift_px = 0.2};

RigidTransform RandomPose(Rng& rng, double size) {
  return {ExpSo3(size * Eigen::Vector3d(rng.Normal(), rng.Normal(), rng.Normal())),
          size * Eigen::Vector3d(rng.Normal(), rng.Normal(), rng.Normal())};
}

Eigen::VectorXd Block(const RigidTransform& pose) {
  return Eigen::Map<const Eigen::VectorXd>(pose.data(), 7);
}

TEST(MeasurementNoise, SqrtInformationInvertsTheCovariance) {
  const NoiseOptions noise;
  for (const double scale : {1.0, 1.2, 3.6}) {
    const Eigen::Matrix3d W = SqrtInformation(noise, scale);
    EXPECT_TRUE((W * MeasurementCovariance(noise, scale) * W.transpose()).isIdentity(1e-12));
  }
}

TEST(HuberWeight, IsOneInsideAndDecreasesOutside) {
  EXPECT_EQ(HuberWeight(3.99, 2.0), 1.0);
  EXPECT_DOUBLE_EQ(HuberWeight(16.0, 2.0), 0.5);
}

TEST(PoseManifold, PlusAndMinusUndoEachOther) {
  Rng rng(1, "manifold");
  const PoseManifold manifold;
  for (int trial = 0; trial < 100; ++trial) {
    const RigidTransform x = RandomPose(rng, 1.0);
    const RigidTransform y = RandomPose(rng, 1.0);
    Vector6d delta;
    manifold.Minus(y.data(), x.data(), delta.data());
    RigidTransform back;
    manifold.Plus(x.data(), delta.data(), back.data());
    EXPECT_LT(y.Minus(back).norm(), 1e-12);
  }
}

TEST(ReprojectionCost, IsZeroAtTheTruth) {
  const RigidTransform pose(ExpSo3({0.1, -0.2, 0.05}), Eigen::Vector3d(1.0, 2.0, 3.0));
  const Eigen::Vector3d p_in_camera(1.5, -0.5, 12.0);
  const auto value = EvaluateReprojection(kCamera, *kCamera.Project(p_in_camera),
                                          Eigen::Matrix3d::Identity(), pose, pose * p_in_camera);
  EXPECT_LT(value.r.norm(), 1e-9);
}

TEST(ReprojectionCost, MatchesHandComputedValue) {
  // A point 10 m ahead and 1 m to the right: u = 600 + 70, disparity 37.8, right shift 0.2.
  const auto value =
      EvaluateReprojection(kCamera, {669.0, 180.0, 632.4}, 2.0 * Eigen::Matrix3d::Identity(),
                           RigidTransform(), {1.0, 0.0, 10.0});
  EXPECT_NEAR(value.r[0], 2.0, 1e-9);
  EXPECT_NEAR(value.r[1], 0.0, 1e-9);
  EXPECT_NEAR(value.r[2], 0.0, 1e-9);
}

TEST(ReprojectionCost, StaysFiniteBehindTheCamera) {
  const auto value = EvaluateReprojection(kCamera, {600, 180, 590}, Eigen::Matrix3d::Identity(),
                                          RigidTransform(), {0.1, 0.1, -5.0});
  EXPECT_TRUE(value.r.allFinite());
}

TEST(ReprojectionCost, JacobiansMatchDifferences) {
  Rng rng(2, "reprojection");
  const PoseManifold manifold;
  for (int trial = 0; trial < 20; ++trial) {
    const RigidTransform pose = RandomPose(rng, 0.5);
    const Eigen::Vector3d point =
        pose * Eigen::Vector3d(rng.Uniform(-4, 4), rng.Uniform(-2, 2), rng.Uniform(4, 40));
    const ReprojectionCost cost(kCamera, {610, 170, 580}, SqrtInformation({}, 1.44));
    EXPECT_TRUE(test::CostJacobiansMatch(
        cost, {{Block(pose), &manifold}, {point, nullptr}, {Eigen::VectorXd::Constant(6, 0.1)}},
        1e-5));
  }
}

WindowPrior RandomPrior(int frames, Rng& rng) {
  WindowPrior prior;
  for (int i = 0; i < frames; ++i) {
    prior.frames.push_back(FrameId{i});
    prior.linearization_point.push_back(RandomPose(rng, 0.5));
  }
  const int columns = 6 * frames + 6;
  prior.J0 = Eigen::MatrixXd::NullaryExpr(columns - 2, columns, [&] { return rng.Normal(); });
  prior.r0 = Eigen::VectorXd::NullaryExpr(columns - 2, [&] { return rng.Normal(); });
  return prior;
}

TEST(PriorCost, IsR0AtTheLinearizationPoint) {
  Rng rng(3, "prior");
  const WindowPrior prior = RandomPrior(2, rng);
  const PriorCost cost(prior);
  const double* blocks[] = {prior.linearization_point[0].data(),
                            prior.linearization_point[1].data(), prior.right_field_point_px.data()};
  Eigen::VectorXd r(prior.r0.size());
  ASSERT_TRUE(cost.Evaluate(blocks, r.data(), nullptr));
  EXPECT_LT((r - prior.r0).norm(), 1e-12);
}

TEST(PriorCost, JacobiansMatchDifferencesAwayFromTheLinearizationPoint) {
  Rng rng(4, "prior");
  const WindowPrior prior = RandomPrior(3, rng);
  const PriorCost cost(prior);
  const PoseManifold manifold;
  std::vector<test::ParameterBlock> blocks;
  for (const RigidTransform& point : prior.linearization_point) {
    const Vector6d step = Vector6d::NullaryExpr([&] { return 0.2 * rng.Normal(); });
    blocks.push_back({Block(point.Plus(step)), &manifold});
  }
  blocks.push_back({Eigen::VectorXd::Constant(6, 0.3)});
  EXPECT_TRUE(test::CostJacobiansMatch(cost, blocks, 1e-6));
}

}  // namespace
}  // namespace cvo::costs_test
