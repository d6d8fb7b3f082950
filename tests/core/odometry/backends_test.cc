// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// Compares our solver with Ceres on the windows that the estimator creates.
#include <gtest/gtest.h>

#include <algorithm>

#include "core/ceres/ceres_solvers.h"
#include "core/odometry/axes.h"
#include "tests/support/moving_world.h"
#include "variants/ablations.h"
#include "variants/paper.h"

namespace cvo {
namespace {

using test::MovingWorld;

// The largest difference so far between the two solutions of a problem.
struct Agreement {
  int windows = 0;
  int clusters = 0;
  double pose = 0.0;  // in the tangent space, m and rad

  void Add(const std::vector<RigidTransform>& a, const std::vector<RigidTransform>& b) {
    for (std::size_t i = 0; i < a.size(); ++i) pose = std::max(pose, a[i].Minus(b[i]).norm());
  }
};
Agreement agreement;

constexpr SolverOptions kToConvergence = {.iterations = 200, .function_tolerance = 0.0};

// Solves every problem with both solvers, to convergence. The estimator continues with the usual
// solution of our solver.
struct BothSolvers {
  static SolverSummary Solve(const NoiseOptions& noise, const SolverOptions& options,
                             WindowProblem& problem) {
    WindowProblem own = problem;
    WindowProblem ceres = problem;
    OwnSchur::Solve(noise, kToConvergence, own);
    CeresSolver::Solve(noise, kToConvergence, ceres);
    agreement.Add(own.world_from_camera, ceres.world_from_camera);
    ++agreement.windows;
    return OwnSchur::Solve(noise, options, problem);
  }
  static SolverSummary Solve(const NoiseOptions& noise, const SolverOptions& options,
                             const MotionPriorSteps& steps, ClusterProblem& problem) {
    ClusterProblem own = problem;
    ClusterProblem ceres = problem;
    OwnSchur::Solve(noise, kToConvergence, steps, own);
    CeresSolver::Solve(noise, kToConvergence, steps, ceres);
    agreement.Add(own.world_from_object, ceres.world_from_object);
    ++agreement.clusters;
    return OwnSchur::Solve(noise, options, steps, problem);
  }
};

template <typename V>
struct WithBoth : V {
  using Solver = BothSolvers;
};

template <typename V>
Agreement Watch(int frames) {
  agreement = {};
  const MovingWorld world(5, test::TwoBodies());
  TaskPool pool(1);
  Options options;
  V::SetDefaults(options);
  // Field coefficients that few points constrain have no sharp minimum.
  options.noise.right_mean_px = 0.0;
  const auto odometry = MakeOdometry(StepsOf<WithBoth<V>>(), {world.camera(), options, 0}, pool);
  StageTimes times;
  for (int i = 0; i < frames; ++i) odometry->Process(world.Observe(i, 0.3).frame, times);
  return agreement;
}

TEST(Backends, AgreeOnTheWindowsOfFull) {
  const Agreement agreed = Watch<Full>(24);
  EXPECT_GE(agreed.windows, 23);
  EXPECT_GE(agreed.clusters, 20);
  EXPECT_LT(agreed.pose, 1e-6);
}

TEST(Backends, AgreeOnTheWindowsOfClusterVo) {
  const Agreement agreed = Watch<Paper>(24);
  EXPECT_GE(agreed.clusters, 20);
  EXPECT_LT(agreed.pose, 1e-6);
}

}  // namespace
}  // namespace cvo
