// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/support/ceres_solvers.h"

#include <ceres/loss_function.h>
#include <ceres/ordered_groups.h>
#include <ceres/problem.h>
#include <ceres/solver.h>

#include <deque>
#include <memory>

#include "tests/support/ceres_costs.h"

namespace cvo::test {
namespace {

ceres::Problem::Options NonOwningOptions() {
  ceres::Problem::Options options;
  options.cost_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  options.loss_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  options.manifold_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  options.disable_all_safety_checks = true;
  return options;
}

void AddPrior(WindowProblem& problem, PriorCost& cost, ceres::Problem& ceres_problem) {
  std::vector<double*> blocks;
  for (const FrameId id : problem.prior.frames) {
    blocks.push_back(problem.world_from_camera[FrameIndex(problem, id)].data());
  }
  blocks.push_back(problem.camera.right_field_px.data());
  ceres_problem.AddResidualBlock(&cost, nullptr, blocks);
}

ceres::Solver::Options CeresOptions(const SolverOptions& options, WindowProblem& problem) {
  ceres::Solver::Options ceres_options;
  ceres_options.linear_solver_type = ceres::DENSE_SCHUR;
  ceres_options.max_num_iterations = options.iterations;
  ceres_options.function_tolerance = options.function_tolerance;
  ceres_options.num_threads = 1;
  ceres_options.logging_type = ceres::SILENT;
  auto ordering = std::make_shared<ceres::ParameterBlockOrdering>();
  for (Eigen::Vector3d& point : problem.points) ordering->AddElementToGroup(point.data(), 0);
  for (RigidTransform& pose : problem.world_from_camera) {
    ordering->AddElementToGroup(pose.data(), 1);
  }
  ordering->AddElementToGroup(problem.camera.right_field_px.data(), 1);
  ceres_options.linear_solver_ordering = ordering;
  return ceres_options;
}

SolverSummary Summary(const ceres::Solver::Summary& summary) {
  const SolverEnding ending =
      summary.termination_type == ceres::CONVERGENCE
          ? SolverEnding::kConverged
          : (summary.termination_type == ceres::NO_CONVERGENCE ? SolverEnding::kIterationLimit
                                                               : SolverEnding::kNoUsableStep);
  return {ending, static_cast<int>(summary.iterations.size()) - 1, summary.initial_cost,
          summary.final_cost};
}

}  // namespace

SolverSummary SolveWindowWithCeres(const NoiseOptions& noise, const SolverOptions& options,
                                   WindowProblem& problem) {
  PoseManifold manifold;
  ceres::HuberLoss loss(noise.huber);
  std::deque<ReprojectionCost> costs;  // never moves its elements
  PriorCost prior_cost(problem.prior);
  ceres::Problem ceres_problem(NonOwningOptions());
  for (std::size_t i = 0; i < problem.frames.size(); ++i) {
    double* block = problem.world_from_camera[i].data();
    ceres_problem.AddParameterBlock(block, 7, &manifold);
    if (problem.is_fixed[i]) ceres_problem.SetParameterBlockConstant(block);
  }
  double* right_field = problem.camera.right_field_px.data();
  ceres_problem.AddParameterBlock(right_field, 6);
  if (problem.is_right_field_fixed) ceres_problem.SetParameterBlockConstant(right_field);
  for (Eigen::Vector3d& point : problem.points) ceres_problem.AddParameterBlock(point.data(), 3);
  for (const ReprojectionFactor& factor : problem.factors) {
    costs.emplace_back(problem.camera, factor.z_px, factor.sqrt_information);
    ceres_problem.AddResidualBlock(&costs.back(), &loss,
                                   problem.world_from_camera[factor.pose].data(),
                                   problem.points[factor.point].data(), right_field);
  }
  AddPrior(problem, prior_cost, ceres_problem);

  ceres::Solver::Summary summary;
  ceres::Solve(CeresOptions(options, problem), &ceres_problem, &summary);
  return Summary(summary);
}

SolverSummary SolveClusterWithCeres(const NoiseOptions& noise, const SolverOptions& options,
                                    std::span<const double> power_densities,
                                    ClusterProblem& problem) {
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
  return Summary(summary);
}

}  // namespace cvo::test
