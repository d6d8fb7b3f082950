// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/solvers/cluster_problem.h"
#include "core/solvers/motion_prior.h"

namespace cvo {

// Motion prior over the frames of a problem.
struct MotionPriorSteps {
  // Power density q in m^2/s^3, one per step from frame to frame. Empty: no prior; each velocity is
  // then the difference to the preceding frame's position.
  std::vector<double> power_densities;
  // Power density q in rad^2/s^3, one per change of the angular velocity over frames i, i + 1 and
  // i + 2. Empty: no prior on orientations.
  std::vector<double> turn_densities;
};

// Minimises a cluster's energy in place (section 3.3 of the paper, dynamic clusters) over all poses
// but the oldest, the velocities and the points. With a single frame, only the points move. Throws
// Error if array sizes are inconsistent, factors are not sorted, times do not increase, or a
// density is not positive.
SolverSummary SolveClusterSteps(const NoiseOptions& noise, const SolverOptions& options,
                                const MotionPriorSteps& steps, ClusterProblem& problem);

// Sets the velocities after a solve without a motion prior: that of each frame is the mean velocity
// since the preceding frame; the first frame takes that of the second.
void DifferentiatePositions(ClusterProblem& problem);

// Evaluates a motion prior policy (motion_prior.h) for the problem's frames.
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
