// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/solvers/cluster_problem.h"
#include "core/solvers/motion_prior.h"

namespace cvo {

// The motion prior of a problem's frames.
struct MotionPriorSteps {
  // q in m^2/s^3 by step from frame to frame; empty: none, velocities become differences to the
  // frame before.
  std::vector<double> power_densities;
  // q in rad^2/s^3 by change of the angular velocity, of frames i, i + 1 and i + 2; empty:
  // orientations are free.
  std::vector<double> turn_densities;
};

// Minimises a cluster's energy in place (section 3.3 of the paper, dynamic clusters): poses but the
// oldest, velocities, points. With a single frame only points move. Throws Error where arrays do
// not fit each other or time does not increase.
SolverSummary SolveClusterSteps(const NoiseOptions& noise, const SolverOptions& options,
                                const MotionPriorSteps& steps, ClusterProblem& problem);

// What a solver does after a solution without a prior: the velocity of each frame is that from the
// frame before, the first one's is the second one's.
void DifferentiatePositions(ClusterProblem& problem);

// The motion prior of a policy (motion_prior.h) for the problem's frames.
template <MotionPriorPolicy MotionPrior>
MotionPriorSteps StepsOfPrior(const MotionPriorOptions& motion, const ClusterProblem& problem) {
  MotionPriorSteps steps;
  if constexpr (MotionPrior::kLinksFrames) {
    for (std::size_t i = 1; i < problem.time_s.size(); ++i) {
      const double dt_s = problem.time_s[i] - problem.time_s[i - 1];
      steps.power_densities.push_back(MotionPrior::PowerDensity(motion, dt_s));
    }
  }
  if constexpr (MotionPrior::kLinksOrientations) {
    for (std::size_t i = 2; i < problem.time_s.size(); ++i) {
      const Eigen::Vector3d turn = LogSo3(problem.world_from_object[i].rotation() *
                                          problem.world_from_object[i - 2].rotation().conjugate());
      const double rate_rad_s = turn.norm() / (problem.time_s[i] - problem.time_s[i - 2]);
      steps.turn_densities.push_back(TurnDensity(motion, rate_rad_s));
    }
  }
  return steps;
}

}  // namespace cvo
