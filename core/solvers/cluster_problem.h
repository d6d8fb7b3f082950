// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/geometry/rigid_transform.h"
#include "core/geometry/stereo_camera.h"
#include "core/solvers/measurement_noise.h"
#include "core/solvers/window_solver.h"

namespace cvo {

// What observations that left the window said of a point: 1/2 ||sqrt_information (p - mean)||^2.
struct PointPrior {
  Eigen::Vector3d mean_in_object = Eigen::Vector3d::Zero();
  Eigen::Matrix3d sqrt_information = Eigen::Matrix3d::Zero();  // zero: nothing is known
};

// The energy of one cluster over its frames in T_t (section 3.3 of the paper, dynamic clusters), as
// plain arrays. The camera is held, and so is the oldest pose: it was optimised most often. The
// frames need not follow each other: the prior is exact for any time between them.
struct ClusterProblem {
  StereoCamera camera;
  std::vector<RigidTransform> world_from_camera;  // by frame, oldest first
  std::vector<double> time_s;                     // by frame, increasing; any origin
  std::vector<RigidTransform> world_from_object;  // by frame; [0] is held
  std::vector<Eigen::Vector3d> velocity_m_s;      // by frame, of the object's origin, in world
  std::vector<Eigen::Vector3d> points;            // p_in_object
  std::vector<PointPrior> point_priors;           // by point
  std::vector<ReprojectionFactor> factors;        // by point, then by frame (`pose`)
};

}  // namespace cvo
