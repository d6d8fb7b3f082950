// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/solvers/cluster_solver.h"
#include "core/solvers/window_solver.h"

namespace cvo {

// Policy: minimises the same energies with the Ceres library: dense Schur complement, one thread,
// the same limits.
struct CeresSolver {
  static SolverSummary Solve(const NoiseOptions& noise, const SolverOptions& options,
                             WindowProblem& problem);
  static SolverSummary Solve(const NoiseOptions& noise, const SolverOptions& options,
                             const MotionPriorSteps& steps, ClusterProblem& problem);
};

}  // namespace cvo
