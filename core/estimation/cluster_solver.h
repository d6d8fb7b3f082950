// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "core/estimation/cluster_problem.h"
#include "core/estimation/motion_prior.h"

namespace cvo {

// Minimises a cluster's energy in place (section 3.3 of the paper, dynamic clusters): poses but the
// oldest, velocities, points. `power_densities`: q in m^2/s^3 by step from frame to frame; empty:
// no motion prior, velocities become differences to the frame before. With a single frame only
// points move. Throws Error where arrays do not fit each other or time does not increase.
SolverSummary SolveClusterSteps(const NoiseOptions& noise, const SolverOptions& options,
                                std::span<const double> power_densities, ClusterProblem& problem);

// The same with the motion prior of a policy (motion_prior.h).
template <typename MotionPrior>
SolverSummary SolveCluster(const NoiseOptions& noise, const SolverOptions& options,
                           const MotionPriorOptions& motion, ClusterProblem& problem) {
  std::vector<double> power_densities;
  if constexpr (MotionPrior::kLinksFrames) {
    for (std::size_t i = 1; i < problem.time_s.size(); ++i) {
      const double dt_s = problem.time_s[i] - problem.time_s[i - 1];
      power_densities.push_back(MotionPrior::PowerDensity(motion, dt_s));
    }
  }
  return SolveClusterSteps(noise, options, power_densities, problem);
}

}  // namespace cvo
