// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/geometry/rigid_transform.h"
#include "core/geometry/stereo_camera.h"
#include "core/solvers/motion_prior.h"
#include "core/solvers/reprojection_cost.h"
#include "core/solvers/window_solver.h"

namespace cvo {

// Prior on a point from observations that have left the window, with the energy
// 1/2 ||sqrt_information (p - mean)||^2.
struct PointPrior {
  Eigen::Vector3d mean_in_object = Eigen::Vector3d::Zero();
  Eigen::Matrix3d sqrt_information = Eigen::Matrix3d::Zero();  // zero: no information
};

// The energy of one cluster over its frames in T_t (Eq. 13 of the paper), as plain arrays. The
// camera poses are held fixed, and so is the oldest object pose, because it has been optimised most
// often. The frames need not be consecutive: the motion prior is exact for any time step.
struct ClusterProblem {
  StereoCamera camera;
  std::vector<RigidTransform> world_from_camera;  // per frame, oldest first
  std::vector<double> time_s;                     // per frame, increasing; any origin
  std::vector<RigidTransform> world_from_object;  // per frame; [0] is held fixed
  std::vector<Eigen::Vector3d> velocity_m_s;      // per frame: of the object's origin, in world
  std::vector<Eigen::Vector3d> points;            // p_in_object
  std::vector<PointPrior> point_priors;           // per point
  std::vector<ReprojectionFactor> factors;        // sorted by point, then by frame (`pose`)
};

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
// but the oldest, the velocities and the points. With a single frame, only the points move.
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
