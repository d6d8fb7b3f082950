// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <concepts>

#include "core/solvers/cluster_solver.h"
#include "core/solvers/window_solver.h"

namespace cvo {

// Minimises the energies of windows in place.
template <typename Policy>
concept SolverPolicy = requires(const NoiseOptions& noise, const SolverOptions& options,
                                const MotionPriorSteps& steps, WindowProblem& window,
                                ClusterProblem& cluster) {
  { Policy::Solve(noise, options, window) } -> std::same_as<SolverSummary>;
  { Policy::Solve(noise, options, steps, cluster) } -> std::same_as<SolverSummary>;
};

// Policy: our own Schur complement solver (METHOD.md 7.5).
struct OwnSchur {
  static SolverSummary Solve(const NoiseOptions& noise, const SolverOptions& options,
                             WindowProblem& problem) {
    return SolveWindow(noise, options, problem);
  }
  static SolverSummary Solve(const NoiseOptions& noise, const SolverOptions& options,
                             const MotionPriorSteps& steps, ClusterProblem& problem) {
    return SolveClusterSteps(noise, options, steps, problem);
  }
};

// Minimises a cluster's energy in place, with the motion prior of a policy.
template <MotionPriorPolicy MotionPrior, SolverPolicy Solver = OwnSchur>
SolverSummary SolveCluster(const NoiseOptions& noise, const SolverOptions& options,
                           const MotionPriorOptions& motion, ClusterProblem& problem) {
  return Solver::Solve(noise, options, StepsOfPrior<MotionPrior>(motion, problem), problem);
}

}  // namespace cvo
