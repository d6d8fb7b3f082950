// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/geometry/rigid_transform.h"
#include "core/geometry/stereo_camera.h"
#include "core/solvers/measurement_noise.h"

namespace cvo {

// A point of known position, observed in the frame whose camera pose is to be estimated.
struct PointMeasurement {
  Eigen::Vector3d p_in_world = Eigen::Vector3d::Zero();
  Eigen::Vector3d z_px = Eigen::Vector3d::Zero();
  Eigen::Matrix3d sqrt_information = Eigen::Matrix3d::Identity();
};

struct CameraSolution {
  RigidTransform world_from_camera;
  std::vector<char> is_inlier;  // per measurement: squared whitened error within the gate
  int inliers = 0;
};

// Minimises sum rho(||z - pi(camera_from_world p)||^2) over the camera pose, with the points held
// fixed and residuals whitened: Gauss-Newton with the Huber loss. From the second round on,
// measurements outside the gate are left out; they may return in a later round.
CameraSolution SolveCamera(const StereoCamera& camera,
                           std::span<const PointMeasurement> measurements,
                           const RigidTransform& initial, const NoiseOptions& noise);

// Determines which measurements are inliers of the given camera pose.
CameraSolution ClassifyMeasurements(const StereoCamera& camera,
                                    std::span<const PointMeasurement> measurements,
                                    const RigidTransform& world_from_camera, double gate);

// Returns how much of the image the inliers cover: the number of cells of a 12 x 12 grid that
// contain one. A moving body may have more measurements than the static scene, but it does not
// cover more of the image.
int CoveredCells(const StereoCamera& camera, std::span<const PointMeasurement> measurements,
                 std::span<const char> is_inlier);

// Whitened residual of one measurement; empty if the point is behind the camera.
std::optional<Eigen::Vector3d> WhitenedError(const StereoCamera& camera,
                                             const PointMeasurement& measurement,
                                             const RigidTransform& camera_from_world);

}  // namespace cvo
