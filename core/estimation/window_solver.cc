// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/estimation/window_solver.h"

#include <ceres/loss_function.h>
#include <ceres/ordered_groups.h>
#include <ceres/problem.h>
#include <ceres/solver.h>

#include <algorithm>
#include <deque>
#include <memory>

#include "core/base/error.h"
#include "core/estimation/pose_manifold.h"
#include "core/estimation/prior_cost.h"
#include "core/estimation/reprojection_cost.h"

namespace cvo {
namespace {

ceres::Problem::Options BorrowEverything() {
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
    const auto it = std::lower_bound(problem.frames.begin(), problem.frames.end(), id);
    Require(it != problem.frames.end() && *it == id, "SolveWindow: the prior names unknown frames");
    blocks.push_back(problem.world_from_camera[it - problem.frames.begin()].data());
  }
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
  ceres_options.linear_solver_ordering = ordering;
  return ceres_options;
}

}  // namespace

SolverSummary SolveWindow(const StereoCamera& camera, const NoiseOptions& noise,
                          const SolverOptions& options, WindowProblem& problem) {
  PoseManifold manifold;
  ceres::HuberLoss loss(noise.huber);
  std::deque<ReprojectionCost> costs;  // never moves its elements
  PriorCost prior_cost(problem.prior);
  ceres::Problem ceres_problem(BorrowEverything());
  for (std::size_t i = 0; i < problem.frames.size(); ++i) {
    double* block = problem.world_from_camera[i].data();
    ceres_problem.AddParameterBlock(block, 7, &manifold);
    if (problem.is_fixed[i]) ceres_problem.SetParameterBlockConstant(block);
  }
  for (Eigen::Vector3d& point : problem.points) ceres_problem.AddParameterBlock(point.data(), 3);
  for (const ReprojectionFactor& factor : problem.factors) {
    costs.emplace_back(camera, factor.z_px, factor.sqrt_information);
    ceres_problem.AddResidualBlock(&costs.back(), &loss,
                                   problem.world_from_camera[factor.pose].data(),
                                   problem.points[factor.point].data());
  }
  if (!problem.prior.empty()) AddPrior(problem, prior_cost, ceres_problem);

  ceres::Solver::Summary summary;
  ceres::Solve(CeresOptions(options, problem), &ceres_problem, &summary);
  return {static_cast<int>(summary.iterations.size()) - 1, summary.initial_cost,
          summary.final_cost};
}

}  // namespace cvo
