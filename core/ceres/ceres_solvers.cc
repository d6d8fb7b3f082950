// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/ceres/ceres_solvers.h"

#include <ceres/loss_function.h>
#include <ceres/ordered_groups.h>
#include <ceres/problem.h>
#include <ceres/solver.h>

#include <deque>
#include <memory>

#include "core/ceres/ceres_costs.h"

namespace cvo {
namespace {

using ceres_costs::MotionPriorCost;
using ceres_costs::ObjectReprojectionCost;
using ceres_costs::PointPriorCost;
using ceres_costs::PoseManifold;
using ceres_costs::PriorCost;
using ceres_costs::ReprojectionCost;
using ceres_costs::TurnPriorCost;

using Ordering = std::shared_ptr<ceres::ParameterBlockOrdering>;

ceres::Problem::Options NonOwningOptions() {
  ceres::Problem::Options options;
  options.cost_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  options.loss_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  options.manifold_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  options.disable_all_safety_checks = true;
  return options;
}

SolverSummary RunCeres(const SolverOptions& options, const Ordering& ordering,
                       ceres::Problem& problem) {
  ceres::Solver::Options ceres_options;
  ceres_options.linear_solver_type = ceres::DENSE_SCHUR;
  ceres_options.max_num_iterations = options.iterations;
  ceres_options.function_tolerance = options.function_tolerance;
  ceres_options.num_threads = 1;
  ceres_options.logging_type = ceres::SILENT;
  ceres_options.linear_solver_ordering = ordering;
  ceres::Solver::Summary summary;
  ceres::Solve(ceres_options, &problem, &summary);
  const SolverEnding ending =
      summary.termination_type == ceres::CONVERGENCE
          ? SolverEnding::kConverged
          : (summary.termination_type == ceres::NO_CONVERGENCE ? SolverEnding::kIterationLimit
                                                               : SolverEnding::kNoUsableStep);
  return {ending, static_cast<int>(summary.iterations.size()) - 1, summary.initial_cost,
          summary.final_cost};
}

void AddPrior(WindowProblem& problem, PriorCost& cost, ceres::Problem& ceres_problem) {
  std::vector<double*> blocks;
  for (const FrameId id : problem.prior.frames) {
    blocks.push_back(problem.world_from_camera[FrameIndex(problem, id)].data());
  }
  blocks.push_back(problem.camera.right_field_px.data());
  ceres_problem.AddResidualBlock(&cost, nullptr, blocks);
}

// Within a group, Ceres orders blocks by their addresses, which differ from run to run. Each kind
// of variable, stored contiguously, therefore has a group of its own. Points are eliminated first.
enum OrderingGroup { kPoints, kPoses, kVelocities, kField };

Ordering OrderingOf(WindowProblem& problem) {
  auto ordering = std::make_shared<ceres::ParameterBlockOrdering>();
  for (Eigen::Vector3d& point : problem.points) ordering->AddElementToGroup(point.data(), kPoints);
  for (RigidTransform& pose : problem.world_from_camera) {
    ordering->AddElementToGroup(pose.data(), kPoses);
  }
  ordering->AddElementToGroup(problem.camera.right_field_px.data(), kField);
  return ordering;
}

// A cluster's problem in Ceres; owns the cost functions that the Ceres problem points to.
class CeresCluster {
 public:
  CeresCluster(const NoiseOptions& noise, const MotionPriorSteps& steps, ClusterProblem& problem)
      : problem_(problem), loss_(noise.huber), ceres_problem_(NonOwningOptions()) {
    AddPosesAndPoints();
    for (const ReprojectionFactor& factor : problem.factors) AddReprojection(factor);
    for (std::size_t i = 0; i < steps.power_densities.size(); ++i) {
      AddStep(steps.power_densities[i], i);
    }
    for (std::size_t i = 0; i < steps.turn_densities.size(); ++i) {
      AddTurn(steps.turn_densities[i], i);
    }
    if (steps.power_densities.empty()) return;
    for (Eigen::Vector3d& v : problem.velocity_m_s)
      ordering_->AddElementToGroup(v.data(), kVelocities);
  }

  SolverSummary Minimize(const SolverOptions& options) {
    return RunCeres(options, ordering_, ceres_problem_);
  }

 private:
  void AddPosesAndPoints() {
    for (RigidTransform& pose : problem_.world_from_object) {
      ceres_problem_.AddParameterBlock(pose.data(), 7, &manifold_);
      ordering_->AddElementToGroup(pose.data(), kPoses);
    }
    ceres_problem_.SetParameterBlockConstant(problem_.world_from_object[0].data());
    for (std::size_t i = 0; i < problem_.points.size(); ++i) {
      double* point = problem_.points[i].data();
      ceres_problem_.AddParameterBlock(point, 3);
      ordering_->AddElementToGroup(point, kPoints);
      if (problem_.point_priors[i].sqrt_information.isZero(0.0)) continue;
      points_.emplace_back(problem_.point_priors[i]);
      ceres_problem_.AddResidualBlock(&points_.back(), nullptr, point);
    }
  }

  void AddReprojection(const ReprojectionFactor& factor) {
    reprojections_.emplace_back(problem_.camera, problem_.world_from_camera[factor.pose],
                                factor.z_px, factor.sqrt_information);
    ceres_problem_.AddResidualBlock(&reprojections_.back(), &loss_,
                                    problem_.world_from_object[factor.pose].data(),
                                    problem_.points[factor.point].data());
  }

  double StepTime(std::size_t i) const { return problem_.time_s[i + 1] - problem_.time_s[i]; }

  void AddStep(double power_density, std::size_t i) {
    steps_.emplace_back(WhitenMotionPrior(power_density, StepTime(i)));
    ceres_problem_.AddResidualBlock(&steps_.back(), nullptr, problem_.world_from_object[i].data(),
                                    problem_.velocity_m_s[i].data(),
                                    problem_.world_from_object[i + 1].data(),
                                    problem_.velocity_m_s[i + 1].data());
  }

  void AddTurn(double power_density, std::size_t i) {
    turns_.emplace_back(power_density, std::array<double, 2>{StepTime(i), StepTime(i + 1)});
    ceres_problem_.AddResidualBlock(&turns_.back(), nullptr, problem_.world_from_object[i].data(),
                                    problem_.world_from_object[i + 1].data(),
                                    problem_.world_from_object[i + 2].data());
  }

  ClusterProblem& problem_;
  PoseManifold manifold_;
  ceres::HuberLoss loss_;
  std::deque<ObjectReprojectionCost> reprojections_;  // a deque never moves its elements
  std::deque<PointPriorCost> points_;
  std::deque<MotionPriorCost> steps_;
  std::deque<TurnPriorCost> turns_;
  Ordering ordering_ = std::make_shared<ceres::ParameterBlockOrdering>();
  ceres::Problem ceres_problem_;
};

}  // namespace

SolverSummary CeresSolver::Solve(const NoiseOptions& noise, const SolverOptions& options,
                                 WindowProblem& problem) {
  PoseManifold manifold;
  ceres::HuberLoss loss(noise.huber);
  std::deque<ReprojectionCost> costs;
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
  return RunCeres(options, OrderingOf(problem), ceres_problem);
}

SolverSummary CeresSolver::Solve(const NoiseOptions& noise, const SolverOptions& options,
                                 const MotionPriorSteps& steps, ClusterProblem& problem) {
  const SolverSummary summary = CeresCluster(noise, steps, problem).Minimize(options);
  if (steps.power_densities.empty()) DifferentiatePositions(problem);
  return summary;
}

}  // namespace cvo
