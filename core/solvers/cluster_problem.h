// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/geometry/rigid_transform.h"
#include "core/geometry/stereo_camera.h"
#include "core/solvers/measurement_noise.h"
#include "core/solvers/window_solver.h"

namespace cvo {

// Prior on a point from observations that have left the window, with the energy
// 1/2 ||sqrt_information (p - mean)||^2.
struct PointPrior {
  Eigen::Vector3d mean_in_object = Eigen::Vector3d::Zero();
  Eigen::Matrix3d sqrt_information = Eigen::Matrix3d::Zero();  // zero: no information
};

// The energy of one cluster over its frames in T_t (section 3.3 of the paper, dynamic clusters), as
// plain arrays. The camera poses are held fixed, and so is the oldest object pose, because it has
// been optimised most often. The frames need not be consecutive: the motion prior is exact for any
// time step.
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

}  // namespace cvo
