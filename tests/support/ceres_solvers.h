// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "core/solvers/cluster_problem.h"

namespace cvo::test {

// SolveWindow and SolveClusterSteps by Ceres (dense Schur complement, one thread): the reference
// that the product's solver must agree with. Velocities without a prior stay as they are.
SolverSummary SolveWindowWithCeres(const NoiseOptions& noise, const SolverOptions& options,
                                   WindowProblem& problem);
SolverSummary SolveClusterWithCeres(const NoiseOptions& noise, const SolverOptions& options,
                                    std::span<const double> power_densities,
                                    ClusterProblem& problem);

}  // namespace cvo::test
