// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/estimation/cluster_solver.h"

#include <ceres/loss_function.h>
#include <ceres/ordered_groups.h>
#include <ceres/problem.h>
#include <ceres/solver.h>

#include <deque>
#include <memory>

#include "core/base/error.h"
#include "core/estimation/motion_prior_cost.h"
#include "core/estimation/object_reprojection_cost.h"
#include "core/estimation/point_prior_cost.h"
#include "core/estimation/pose_manifold.h"

namespace cvo {
namespace {

void CheckFrames(const ClusterProblem& problem) {
  const std::size_t n = problem.time_s.size();
  Require(n > 0, "ClusterProblem: no frames");
  Require(problem.world_from_camera.size() == n && problem.world_from_object.size() == n &&
              problem.velocity_m_s.size() == n,
          "ClusterProblem: arrays by frame differ in length");
  for (std::size_t i = 1; i < n; ++i) {
    Require(problem.time_s[i] > problem.time_s[i - 1], "ClusterProblem: time_s does not increase");
  }
}

void CheckPoints(const ClusterProblem& problem) {
  const int frames = static_cast<int>(problem.time_s.size());
  const int points = static_cast<int>(problem.points.size());
  Require(problem.point_priors.size() == problem.points.size(),
          "ClusterProblem: points and their priors differ in number");
  int last = 0;
  for (const ReprojectionFactor& factor : problem.factors) {
    Require(
        factor.pose >= 0 && factor.pose < frames && factor.point >= last && factor.point < points,
        "ClusterProblem: factors are not sorted by point or name what is not there");
    last = factor.point;
  }
}

void CheckSteps(std::span<const double> power_densities, const ClusterProblem& problem) {
  Require(power_densities.empty() || power_densities.size() + 1 == problem.time_s.size(),
          "SolveCluster: one power density per step");
  for (const double q : power_densities) Require(q > 0.0, "SolveCluster: q must be positive");
}

// Velocity of each frame: from the frame before; the first one's is the second one's.
void DifferentiatePositions(ClusterProblem& problem) {
  const std::size_t n = problem.time_s.size();
  for (std::size_t i = 1; i < n; ++i) {
    const double dt = problem.time_s[i] - problem.time_s[i - 1];
    problem.velocity_m_s[i] = (problem.world_from_object[i].translation() -
                               problem.world_from_object[i - 1].translation()) /
                              dt;
  }
  if (n > 1) problem.velocity_m_s[0] = problem.velocity_m_s[1];
}

SolverSummary SolveWithCeres(const NoiseOptions& noise, const SolverOptions& options,
                             std::span<const double> power_densities, ClusterProblem& problem) {
  ceres::Problem::Options borrow;
  borrow.cost_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  borrow.loss_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  borrow.manifold_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  PoseManifold manifold;
  ceres::HuberLoss loss(noise.huber);
  std::deque<ObjectReprojectionCost> costs;
  std::deque<PointPriorCost> point_costs;
  std::deque<MotionPriorCost> motion_costs;
  ceres::Problem ceres_problem(borrow);
  auto ordering = std::make_shared<ceres::ParameterBlockOrdering>();
  for (RigidTransform& pose : problem.world_from_object) {
    ceres_problem.AddParameterBlock(pose.data(), 7, &manifold);
    ordering->AddElementToGroup(pose.data(), 1);
  }
  ceres_problem.SetParameterBlockConstant(problem.world_from_object[0].data());
  for (std::size_t i = 0; i < problem.points.size(); ++i) {
    ceres_problem.AddParameterBlock(problem.points[i].data(), 3);
    ordering->AddElementToGroup(problem.points[i].data(), 0);
    if (problem.point_priors[i].sqrt_information.isZero(0.0)) continue;
    point_costs.emplace_back(problem.point_priors[i]);
    ceres_problem.AddResidualBlock(&point_costs.back(), nullptr, problem.points[i].data());
  }
  for (const ReprojectionFactor& factor : problem.factors) {
    costs.emplace_back(problem.camera, problem.world_from_camera[factor.pose], factor.z_px,
                       factor.sqrt_information);
    ceres_problem.AddResidualBlock(&costs.back(), &loss,
                                   problem.world_from_object[factor.pose].data(),
                                   problem.points[factor.point].data());
  }
  for (std::size_t i = 0; i < power_densities.size(); ++i) {
    const double dt_s = problem.time_s[i + 1] - problem.time_s[i];
    motion_costs.emplace_back(WhitenMotionPrior(power_densities[i], dt_s));
    ceres_problem.AddResidualBlock(
        &motion_costs.back(), nullptr, problem.world_from_object[i].data(),
        problem.velocity_m_s[i].data(), problem.world_from_object[i + 1].data(),
        problem.velocity_m_s[i + 1].data());
  }
  if (!power_densities.empty()) {
    for (Eigen::Vector3d& v : problem.velocity_m_s) ordering->AddElementToGroup(v.data(), 1);
  }
  ceres::Solver::Options ceres_options;
  ceres_options.linear_solver_type = ceres::DENSE_SCHUR;
  ceres_options.max_num_iterations = options.iterations;
  ceres_options.function_tolerance = options.function_tolerance;
  ceres_options.num_threads = 1;
  ceres_options.logging_type = ceres::SILENT;
  ceres_options.linear_solver_ordering = ordering;
  ceres::Solver::Summary summary;
  ceres::Solve(ceres_options, &ceres_problem, &summary);
  return {static_cast<int>(summary.iterations.size()) - 1, summary.initial_cost,
          summary.final_cost};
}

}  // namespace

SolverSummary SolveClusterSteps(const NoiseOptions& noise, const SolverOptions& options,
                                std::span<const double> power_densities, ClusterProblem& problem) {
  CheckFrames(problem);
  CheckPoints(problem);
  CheckSteps(power_densities, problem);
  const SolverSummary summary = SolveWithCeres(noise, options, power_densities, problem);
  if (power_densities.empty()) DifferentiatePositions(problem);
  return summary;
}

}  // namespace cvo
