// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include "core/base/error.h"
#include "core/base/rng.h"
#include "core/ceres/ceres_solvers.h"
#include "core/solvers/cluster_solver.h"
#include "core/solvers/schur_solver.h"

namespace cvo::solvers_test {
namespace {

const StereoCamera kCamera = {.fx = 500,
                              .fy = 480,
                              .cx = 320,
                              .cy = 240,
                              .baseline_m = 0.5,
                              .width_px = 640,
                              .height_px = 480,
                              .right_shift_px = 0.1};
const SolverOptions kToConvergence = {.iterations = 100, .function_tolerance = 0.0};

Eigen::Vector3d RandomVector(Rng& rng) { return {rng.Normal(), rng.Normal(), rng.Normal()}; }

RigidTransform RandomPose(Rng& rng, double size) {
  return {ExpSo3(size * RandomVector(rng)), size * RandomVector(rng)};
}

// Returns a window of frames along a curve. Most frames observe each point; some observations are
// outliers.
WindowProblem RandomWindow(int frames, int points, Rng& rng) {
  WindowProblem problem;
  problem.camera = kCamera;
  problem.prior = CalibrationPrior(kCamera, Vector6d::Constant(0.3));
  for (int i = 0; i < frames; ++i) {
    problem.frames.push_back(FrameId{3 * i});
    problem.world_from_camera.emplace_back(ExpSo3({0.0, 0.02 * i, 0.01}),
                                           Eigen::Vector3d(0.1 * i, 0.0, 0.5 * i));
  }
  problem.is_fixed.assign(frames, 0);
  for (int p = 0; p < points; ++p) {
    const Eigen::Vector3d point(rng.Uniform(-3, 3), rng.Uniform(-2, 2), rng.Uniform(7, 15));
    problem.points.push_back(point + 0.05 * RandomVector(rng));
    for (int i = 0; i < frames; ++i) {
      if (rng.Uniform(0, 1) < 0.3) continue;
      const double noise = rng.Uniform(0, 1) < 0.05 ? 10.0 : 0.4;
      const auto z = kCamera.Project(problem.world_from_camera[i].Inverse() * point);
      problem.factors.push_back(
          {i, p, *z + noise * RandomVector(rng), SqrtInformation({}, rng.Uniform(1, 2))});
    }
  }
  for (RigidTransform& pose : problem.world_from_camera) {
    const Vector6d step = Vector6d::NullaryExpr([&] { return 0.01 * rng.Normal(); });
    pose = pose.Plus(step);
  }
  return problem;
}

WindowPrior RandomPrior(const WindowProblem& problem, int first, int count, Rng& rng) {
  WindowPrior prior;
  for (int i = first; i < first + count; ++i) {
    prior.frames.push_back(problem.frames[i]);
    const Vector6d step = Vector6d::NullaryExpr([&] { return 0.02 * rng.Normal(); });
    prior.linearization_point.push_back(problem.world_from_camera[i].Plus(step));
  }
  const int columns = 6 * count + 6;
  prior.J0 = Eigen::MatrixXd::NullaryExpr(columns - 1, columns, [&] { return 5 * rng.Normal(); });
  prior.r0 = Eigen::VectorXd::NullaryExpr(columns - 1, [&] { return 0.1 * rng.Normal(); });
  return prior;
}

void ExpectAgreement(const WindowProblem& problem) {
  WindowProblem own = problem;
  WindowProblem reference = problem;
  const SolverSummary own_summary = SolveWindow({}, kToConvergence, own);
  const SolverSummary summary = CeresSolver::Solve({}, kToConvergence, reference);
  EXPECT_NEAR(own_summary.initial_cost / summary.initial_cost, 1.0, 1e-9);
  EXPECT_NEAR(own_summary.final_cost / summary.final_cost, 1.0, 1e-6);
  EXPECT_LT(own_summary.final_cost, 0.9 * own_summary.initial_cost);
  for (std::size_t i = 0; i < own.frames.size(); ++i) {
    EXPECT_LT(own.world_from_camera[i].Minus(reference.world_from_camera[i]).norm(), 1e-7) << i;
  }
  EXPECT_LT((own.camera.right_field_px - reference.camera.right_field_px).norm(), 1e-6);
}

TEST(MeasurementNoise, SqrtInformationInvertsTheCovariance) {
  const NoiseOptions noise;
  for (const double scale : {1.0, 1.2, 3.6}) {
    const Eigen::Matrix3d W = SqrtInformation(noise, scale);
    EXPECT_TRUE((W * MeasurementCovariance(noise, scale) * W.transpose()).isIdentity(1e-12));
  }
}

TEST(EvaluateReprojection, IsTheErrorInPixelsAndFiniteBehindTheCamera) {
  // A point 10 m ahead and 1 m to the right: u = 320 + 50, disparity 25, right shift 0.1.
  const Eigen::Matrix3d W = 2.0 * Eigen::Matrix3d::Identity();
  const auto at = [&](const Eigen::Vector3d& p_in_world) -> Eigen::Vector3d {
    return EvaluateReprojection(kCamera, {369.0, 240.0, 345.1}, W, {}, p_in_world).r;
  };
  EXPECT_LT((at({1.0, 0.0, 10.0}) - Eigen::Vector3d(2.0, 0.0, 0.0)).norm(), 1e-9);
  EXPECT_TRUE(at({0.1, 0.1, -5.0}).allFinite());
}

TEST(SolveWindow, AgreesWithCeresWithTheOldestFrameFixed) {
  Rng rng(1, "solvers");
  for (const bool is_right_field_fixed : {true, false}) {
    WindowProblem problem = RandomWindow(6, 50, rng);
    problem.is_right_field_fixed = is_right_field_fixed;
    problem.is_fixed[0] = 1;
    ExpectAgreement(problem);
  }
}

TEST(SolveWindow, AgreesWithCeresWithAPriorAndFixedFramesAnywhere) {
  Rng rng(2, "solvers");
  for (const bool is_right_field_fixed : {true, false}) {
    WindowProblem problem = RandomWindow(7, 50, rng);
    problem.is_right_field_fixed = is_right_field_fixed;
    problem.prior = RandomPrior(problem, 1, 4, rng);
    ExpectAgreement(problem);
    problem.is_fixed[2] = problem.is_fixed[5] = 1;
    ExpectAgreement(problem);
  }
}

TEST(SolveWindow, ReportsHowItEnded) {
  Rng rng(5, "solvers");
  WindowProblem problem = RandomWindow(4, 40, rng);
  problem.is_fixed[0] = 1;
  const auto ending = [&](const SolverOptions& options) {
    return SolveWindow({}, options, problem).ending;
  };
  EXPECT_EQ(ending({.iterations = 1, .function_tolerance = 0.0}), SolverEnding::kIterationLimit);
  EXPECT_EQ(ending({.iterations = 100, .function_tolerance = 1e-6}), SolverEnding::kConverged);
}

// A model whose energy increases with every step.
struct Uphill {
  static double Linearize(SchurEquations& equations) {
    equations.SetZero();
    equations.points[0].H.setIdentity();
    equations.points[0].g.setOnes();
    return 1.0;
  }
  static double TryStep(const SchurStep&) { return 2.0; }
  static void AcceptStep() { FAIL() << "it leads uphill"; }
  static double Norm() { return 1.0; }
};

TEST(MinimizeEnergy, ReportsThatNoStepWasUsable) {
  SchurEquations equations({}, 0, 1, {});
  Uphill model;
  const SolverSummary summary = MinimizeEnergy({}, equations, model);
  EXPECT_EQ(summary.ending, SolverEnding::kNoUsableStep);
  EXPECT_EQ(summary.iterations, SolverOptions().iterations);
  EXPECT_EQ(summary.final_cost, 1.0);
}

ClusterProblem RandomCluster(int frames, int points, Rng& rng) {
  ClusterProblem problem;
  problem.camera = kCamera;
  double time_s = 7.0;
  for (int i = 0; i < frames; ++i) {
    time_s += rng.Uniform(0.03, 0.3);
    problem.time_s.push_back(time_s);
    problem.world_from_camera.push_back(RandomPose(rng, 0.1));
    problem.world_from_object.emplace_back(
        ExpSo3({0.1 * i, 0.5, -0.3}), Eigen::Vector3d(0.2 * i, 0.1, 9.0 + rng.Uniform(0, 0.1)));
    problem.velocity_m_s.push_back(RandomVector(rng));
  }
  problem.points.resize(points);
  problem.point_priors.resize(points);
  for (int p = 0; p < points; ++p) {
    const Eigen::Vector3d point = 0.7 * RandomVector(rng);
    problem.points[p] = point + 0.03 * RandomVector(rng);
    if (p % 3 == 0) problem.point_priors[p] = {point, 2.0 * Eigen::Matrix3d::Identity()};
    for (int i = 0; i < frames; ++i) {
      if (rng.Uniform(0, 1) < 0.3) continue;
      const double noise = rng.Uniform(0, 1) < 0.05 ? 10.0 : 0.4;
      const auto z = kCamera.Project(problem.world_from_camera[i].Inverse() *
                                     (problem.world_from_object[i] * point));
      problem.factors.push_back(
          {i, p, *z + noise * RandomVector(rng), SqrtInformation({}, rng.Uniform(1, 2))});
    }
  }
  return problem;
}

TEST(SolveCluster, AgreesWithCeres) {
  Rng rng(5, "solvers");
  for (const double q : {0.0, 0.05, 1.0, 300.0}) {
    const ClusterProblem problem = RandomCluster(8, 30, rng);
    const std::vector<double> q_by_step(q > 0.0 ? 7 : 0, q);
    std::vector<double> turns;
    for (std::size_t i = 0; q >= 1.0 && i < 6; ++i) turns.push_back(0.1 * q * rng.Uniform(1, 9));
    ClusterProblem own = problem;
    ClusterProblem reference = problem;
    const SolverSummary own_summary =
        SolveClusterSteps({}, kToConvergence, {q_by_step, turns}, own);
    const SolverSummary summary =
        CeresSolver::Solve({}, kToConvergence, {q_by_step, turns}, reference);
    EXPECT_NEAR(own_summary.initial_cost / summary.initial_cost, 1.0, 1e-9);
    EXPECT_NEAR(own_summary.final_cost / summary.final_cost, 1.0, 1e-6);
    for (std::size_t i = 0; i < own.time_s.size(); ++i) {
      EXPECT_LT(own.world_from_object[i].Minus(reference.world_from_object[i]).norm(), 1e-7) << q;
      if (q_by_step.empty()) continue;
      EXPECT_LT((own.velocity_m_s[i] - reference.velocity_m_s[i]).norm(), 1e-6) << q;
    }
  }
}

// H dx = -g including the points, as one dense system: poses and shared variables come first.
struct DenseSystem {
  Eigen::MatrixXd H;
  Eigen::VectorXd g;
};

DenseSystem MakeDense(const SchurEquations& equations) {
  const Eigen::Index reduced = equations.g.size();
  const Eigen::Index size = reduced + 3 * static_cast<Eigen::Index>(equations.points.size());
  DenseSystem dense{Eigen::MatrixXd::Zero(size, size), Eigen::VectorXd::Zero(size)};
  dense.H.topLeftCorner(reduced, reduced) = equations.H;
  dense.g.head(reduced) = equations.g;
  for (std::size_t i = 0; i < equations.pose_H.size(); ++i) {
    dense.H.block<6, 6>(6 * i, 6 * i) += equations.pose_H[i];
  }
  for (std::size_t p = 0; p < equations.points.size(); ++p) {
    const Eigen::Index row = reduced + 3 * static_cast<Eigen::Index>(p);
    dense.H.block<3, 3>(row, row) = equations.points[p].H;
    dense.g.segment<3>(row) = equations.points[p].g;
    if (equations.points_see_shared) {
      dense.H.block<3, 6>(row, equations.others_begin()) = equations.points[p].by_shared;
    }
    for (int c = equations.couplings_begin[p]; c < equations.couplings_begin[p + 1]; ++c) {
      const PoseCoupling& coupling = equations.couplings[c];
      dense.H.block<3, 6>(row, 6 * coupling.pose) =
          LeverTransposeTimes(coupling.lever, coupling.M).transpose();
    }
  }
  dense.H = dense.H.selfadjointView<Eigen::Lower>();
  return dense;
}

// Linearises a window at its current state, with right_field_px free.
SchurEquations LinearizedWindow(const WindowProblem& problem) {
  std::vector<int> poses;
  std::vector<CameraView> views;
  for (std::size_t i = 0; i < problem.frames.size(); ++i) {
    poses.push_back(static_cast<int>(i) - 1);
    views.emplace_back(poses[i], problem.world_from_camera[i]);
  }
  SchurEquations equations(poses, 6, problem.points.size(), problem.factors);
  equations.points_see_shared = true;
  equations.SetZero();
  LinearizeReprojections(problem.camera, views, problem.points, problem.factors, 2.796, equations);
  return equations;
}

TEST(SchurSolver, AgreesWithADenseSolverOnTheDampedSystem) {
  Rng rng(6, "solvers");
  const SchurEquations equations = LinearizedWindow(RandomWindow(5, 20, rng));
  const DenseSystem dense = MakeDense(equations);
  SchurSolver solver(equations);
  for (const double radius : {1.0, 1e4}) {
    SchurStep step;
    ASSERT_TRUE(solver.Solve(equations, radius, step));
    Eigen::MatrixXd damped = dense.H;
    damped.diagonal() *= 1.0 + 1.0 / radius;
    const Eigen::VectorXd expected = damped.ldlt().solve(-dense.g);
    EXPECT_LT((step.reduced - expected.head(step.reduced.size())).norm(), 1e-9 * expected.norm());
    for (std::size_t p = 0; p < step.points.size(); ++p) {
      const Eigen::Vector3d point = expected.segment<3>(step.reduced.size() + 3 * p);
      EXPECT_LT((step.points[p] - point).norm(), 1e-9 * expected.norm());
    }
    const double decrease = -dense.g.dot(expected) - 0.5 * expected.dot(dense.H * expected);
    EXPECT_NEAR(step.expected_decrease / decrease, 1.0, 1e-9);
    EXPECT_NEAR(step.norm / expected.norm(), 1.0, 1e-9);
  }
  SchurStep step;
  ASSERT_TRUE(solver.Solve(equations, 1e9, step));
  const Eigen::Index shared = equations.others_begin();
  const Matrix6d covariance = dense.H.inverse().block<6, 6>(shared, shared);
  EXPECT_TRUE((solver.SharedInformation() * covariance).isIdentity(1e-4));
}

TEST(SchurSolver, RefusesIndefiniteSystems) {
  Rng rng(7, "solvers");
  SchurEquations equations = LinearizedWindow(RandomWindow(3, 10, rng));
  equations.points[4].H *= -1.0;
  SchurStep step;
  EXPECT_FALSE(SchurSolver(equations).Solve(equations, 1e4, step));
}

}  // namespace
}  // namespace cvo::solvers_test
