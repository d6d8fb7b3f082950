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

// A point of known position, seen in the frame whose camera is wanted.
struct PointMeasurement {
  Eigen::Vector3d p_in_world = Eigen::Vector3d::Zero();
  Eigen::Vector3d z_px = Eigen::Vector3d::Zero();
  Eigen::Matrix3d sqrt_information = Eigen::Matrix3d::Identity();
};

struct CameraSolution {
  RigidTransform world_from_camera;
  std::vector<char> is_inlier;  // by measurement: squared whitened error within the gate
  int inliers = 0;
};

// min over the camera of sum rho(||z - pi(camera_from_world p)||^2), points held: Gauss-Newton with
// Huber's loss; measurements outside the gate are left out from the second round on and may return.
CameraSolution SolveCamera(const StereoCamera& camera,
                           std::span<const PointMeasurement> measurements,
                           const RigidTransform& initial, const NoiseOptions& noise);

// Which measurements a given camera explains.
CameraSolution ClassifyMeasurements(const StereoCamera& camera,
                                    std::span<const PointMeasurement> measurements,
                                    const RigidTransform& world_from_camera, double gate);

// How much of the image they cover: cells of a grid of 12 x 12 with an inlier. A body may have more
// measurements than the scene, but it does not cover more of the image.
int CoveredCells(const StereoCamera& camera, std::span<const PointMeasurement> measurements,
                 std::span<const char> is_inlier);

// Whitened residual of one measurement; empty where the point is behind the camera.
std::optional<Eigen::Vector3d> WhitenedError(const StereoCamera& camera,
                                             const PointMeasurement& measurement,
                                             const RigidTransform& camera_from_world);

}  // namespace cvo
