// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include "core/base/error.h"
#include "core/base/rng.h"
#include "core/solvers/schur_solver.h"
#include "tests/support/estimator_inputs.h"

namespace cvo::cluster_test {
namespace {

template <typename MotionPrior>
void SolveCluster(const NoiseOptions& noise, const SolverOptions& options,
                  const MotionPriorOptions& motion, ClusterProblem& problem) {
  SolveClusterSteps(noise, options, StepsOfPrior<MotionPrior>(motion, problem), problem);
}

const StereoCamera kCamera = test::CentredCamera(500, 0.5, 640, 480);
const SolverOptions kToConvergence = {.iterations = 80, .function_tolerance = 1e-14};

Eigen::Vector3d RandomVector(Rng& rng) { return {rng.Normal(), rng.Normal(), rng.Normal()}; }

struct Scene {
  std::vector<double> times_s = {0.0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7};
  int points = 30;
  double acceleration_m_s2 = 0.0;
  double depth_m = 10.0;
  double noise_px = 0.0;
};

// Returns the true states of a rotating body followed by a camera, with noisy observations.
ClusterProblem MakeProblem(const Scene& scene, Rng& rng) {
  ClusterProblem problem;
  problem.camera = kCamera;
  problem.time_s = scene.times_s;
  for (int p = 0; p < scene.points; ++p) {
    problem.points.emplace_back(rng.Uniform(-1, 1), rng.Uniform(-0.7, 0.7), rng.Uniform(-1, 1));
  }
  problem.point_priors.resize(problem.points.size());
  const Eigen::Vector3d v(0.6, 0.0, 1.0);
  for (const double t : scene.times_s) {
    const double a = scene.acceleration_m_s2;
    problem.world_from_camera.emplace_back(ExpSo3({0.0, 0.05 * t, 0.0}),
                                           Eigen::Vector3d(0.0, 0.0, t));
    problem.world_from_object.emplace_back(
        ExpSo3({0.0, -0.5 * t, 0.0}) * ExpSo3({0.1, 0.3, 0.0}),
        Eigen::Vector3d(Eigen::Vector3d(0.3, 0.2, scene.depth_m) + v * t +
                        Eigen::Vector3d(0.5 * a * t * t, 0.0, 0.0)));
    problem.velocity_m_s.push_back(v + Eigen::Vector3d(a * t, 0.0, 0.0));
  }
  for (int p = 0; p < scene.points; ++p) {
    for (int i = 0; i < static_cast<int>(scene.times_s.size()); ++i) {
      const auto z = kCamera.Project(problem.world_from_camera[i].Inverse() *
                                     (problem.world_from_object[i] * problem.points[p]));
      problem.factors.push_back(
          {i, p, *z + scene.noise_px * RandomVector(rng), Eigen::Matrix3d::Identity()});
    }
  }
  return problem;
}

void Disturb(ClusterProblem& problem, double size, Rng& rng) {
  for (std::size_t i = 0; i < problem.time_s.size(); ++i) {
    const Vector6d step = Vector6d::NullaryExpr([&] { return size * rng.Normal(); });
    if (i > 0) problem.world_from_object[i] = problem.world_from_object[i].Plus(step);
    problem.velocity_m_s[i] += 10.0 * size * RandomVector(rng);
  }
  for (Eigen::Vector3d& point : problem.points) point += size * RandomVector(rng);
}

// Returns the largest difference between the poses of two problems with the same frames.
double PoseError(const ClusterProblem& a, const ClusterProblem& b) {
  double error = 0.0;
  for (std::size_t i = 0; i < a.time_s.size(); ++i) {
    error = std::max(error, a.world_from_object[i].Minus(b.world_from_object[i]).norm());
  }
  return error;
}

TEST(SolveCluster, ReturnsToTheTruth) {
  Rng rng(3, "cluster");
  const ClusterProblem truth = MakeProblem({}, rng);
  ClusterProblem problem = truth;
  Disturb(problem, 0.03, rng);
  SolveCluster<WhiteNoiseOnAcceleration>({}, kToConvergence, {}, problem);
  EXPECT_LT(PoseError(problem, truth), 1e-6);
  for (std::size_t i = 0; i < truth.time_s.size(); ++i) {
    EXPECT_LT((problem.velocity_m_s[i] - truth.velocity_m_s[i]).norm(), 1e-5);
  }
}

// Returns the rotation of the body from the previous frame to frame i, in world axes.
Eigen::Quaterniond TurnOfStep(const ClusterProblem& problem, std::size_t i) {
  return problem.world_from_object[i].rotation() *
         problem.world_from_object[i - 1].rotation().conjugate();
}

// RMS error of the frame-to-frame motion over several noisy runs.
struct MotionError {
  double translation_m = 0.0;
  double rotation_rad = 0.0;
};
template <typename MotionPrior>
MotionError OneFrameError(const MotionPriorOptions& motion) {
  double sum = 0.0;
  double turn_sum = 0.0;
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    Rng rng(seed, "noisy");
    Scene scene = {.points = 10, .acceleration_m_s2 = 1.0, .depth_m = 20.0};
    const ClusterProblem truth = MakeProblem(scene, rng);
    ClusterProblem problem = truth;
    for (ReprojectionFactor& factor : problem.factors) factor.z_px += 0.5 * RandomVector(rng);
    SolveCluster<MotionPrior>({}, kToConvergence, motion, problem);
    for (std::size_t i = 1; i < truth.time_s.size(); ++i) {
      const Eigen::Vector3d moved = problem.world_from_object[i].translation() -
                                    problem.world_from_object[i - 1].translation();
      const Eigen::Vector3d expected =
          truth.world_from_object[i].translation() - truth.world_from_object[i - 1].translation();
      sum += (moved - expected).squaredNorm();
      const double turn_error =
          RotationAngle(TurnOfStep(truth, i).conjugate() * TurnOfStep(problem, i));
      turn_sum += turn_error * turn_error;
    }
  }
  return {std::sqrt(sum / 70.0), std::sqrt(turn_sum / 70.0)};
}

TEST(SolveCluster, PriorsReduceTheOneFrameErrorUnderNoise) {
  const MotionError without = OneFrameError<NoMotionPrior>({});
  const MotionError still_turning = OneFrameError<WhiteNoiseOnTranslation>({});
  const MotionError with = OneFrameError<WhiteNoiseOnAcceleration>({});
  EXPECT_LT(with.translation_m, 0.7 * without.translation_m);
  EXPECT_GT(with.translation_m, 0.05 * without.translation_m);  // it does not know the truth
  EXPECT_LT(with.rotation_rad, 0.5 * still_turning.rotation_rad);
  EXPECT_GT(with.rotation_rad, 0.01 * still_turning.rotation_rad);
}

// Frames are 0.1 s apart. The body rotates by 0.4 rad in the last step, so at 2 rad/s over the last
// two steps.
TEST(StepsOfPrior, UsesTheMeanRateOfBothSteps) {
  ClusterProblem problem;
  problem.time_s = {0.0, 0.1, 0.2, 0.3};
  problem.world_from_object.resize(4);
  problem.world_from_object[3] = {ExpSo3({0.0, 0.4, 0.0}), Eigen::Vector3d::Zero()};
  const MotionPriorOptions options = {.turn_q_rad2_s3 = 0.1, .turn_rate_rad_s = 2.0};
  const MotionPriorSteps steps = StepsOfPrior<WhiteNoiseOnAcceleration>(options, problem);
  ASSERT_EQ(steps.turn_densities.size(), 2u);
  EXPECT_DOUBLE_EQ(steps.turn_densities[0], 0.1);
  EXPECT_NEAR(steps.turn_densities[1], 0.2, 1e-12);
  EXPECT_TRUE(StepsOfPrior<WhiteNoiseOnTranslation>(options, problem).turn_densities.empty());
}

TEST(SolveCluster, NoPriorIsTheLimitOfLargeQ) {
  Rng rng(5, "cluster");
  ClusterProblem loose = MakeProblem({.noise_px = 0.3}, rng);
  ClusterProblem none = loose;
  SolveCluster<WhiteNoiseOnAcceleration>({}, kToConvergence,
                                         {.q_m2_s3 = 1e10, .turn_q_rad2_s3 = 1e10}, loose);
  SolveCluster<NoMotionPrior>({}, kToConvergence, {}, none);
  EXPECT_LT(PoseError(loose, none), 1e-6);
  const Eigen::Vector3d moved =
      none.world_from_object[3].translation() - none.world_from_object[2].translation();
  EXPECT_LT((none.velocity_m_s[3] - moved / 0.1).norm(), 1e-9);
  EXPECT_EQ(none.velocity_m_s[0], none.velocity_m_s[1]);
}

TEST(SolveCluster, PointPriorHoldsAgainstTheData) {
  Rng rng(7, "cluster");
  const ClusterProblem truth = MakeProblem({.times_s = {0.0, 0.1, 0.2}}, rng);
  ClusterProblem free = truth;
  free.points[0].x() += 0.01;
  ClusterProblem held = free;
  held.point_priors[0] = {held.points[0], 1e4 * Eigen::Matrix3d::Identity()};
  SolveCluster<WhiteNoiseOnAcceleration>({}, kToConvergence, {}, free);
  SolveCluster<WhiteNoiseOnAcceleration>({}, kToConvergence, {}, held);
  EXPECT_LT((free.points[0] - truth.points[0]).norm(), 1e-6);
  EXPECT_LT((held.points[0] - held.point_priors[0].mean_in_object).norm(), 1e-4);
}

TEST(SolveCluster, OptimisesOnlyPointsWithASingleFrame) {
  Rng rng(8, "cluster");
  const ClusterProblem truth = MakeProblem({.times_s = {3.0}}, rng);
  ClusterProblem problem = truth;
  for (Eigen::Vector3d& point : problem.points) point += 0.05 * RandomVector(rng);
  SolveCluster<WhiteNoiseOnAcceleration>({}, kToConvergence, {}, problem);
  EXPECT_EQ(PoseError(problem, truth), 0.0);
  EXPECT_EQ(problem.velocity_m_s[0], truth.velocity_m_s[0]);
  for (std::size_t i = 0; i < truth.points.size(); ++i) {
    EXPECT_LT((problem.points[i] - truth.points[i]).norm(), 1e-6);
  }
}

}  // namespace
}  // namespace cvo::cluster_test
