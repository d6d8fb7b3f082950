// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/base/rng.h"
#include "core/geometry/rigid_transform.h"
#include "core/geometry/stereo_camera.h"
#include "core/solvers/reprojection_cost.h"

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

  bool HalfAgrees() const { return 2 * inliers >= static_cast<int>(is_inlier.size()); }
};

// Minimises sum rho(||z - pi(camera_from_world p)||^2) over the camera pose, with the points held
// fixed and residuals whitened: Gauss-Newton with the Huber loss. From the second round on,
// measurements outside the gate are left out; they may return in a later round.
CameraSolution SolveCamera(const StereoCamera& camera,
                           std::span<const PointMeasurement> measurements,
                           const RigidTransform& initial, const NoiseOptions& noise);
// The same from a pose that is nearly right: the first round, too, leaves out what contradicts it,
// so that a body with more measurements than the scene does not draw the camera to itself.
CameraSolution RefineCamera(const StereoCamera& camera,
                            std::span<const PointMeasurement> measurements,
                            const RigidTransform& initial, const NoiseOptions& noise);

// Determines which measurements are inliers of the given camera pose.
CameraSolution ClassifyMeasurements(const StereoCamera& camera,
                                    std::span<const PointMeasurement> measurements,
                                    const RigidTransform& world_from_camera, double gate);

// Divides space into cubes with sides of four baselines, numbers those that contain a measurement,
// and returns the number for each. A near body may have more measurements than the static scene and
// cover more of the image, but it is in fewer cubes.
std::vector<int> CubesOf(const StereoCamera& camera,
                         std::span<const PointMeasurement> measurements);
// Number of different cubes that contain an inlier.
int CountCubes(std::span<const int> cubes, std::span<const char> is_inlier);

// Whitened residual of one measurement; empty if the point is behind the camera.
std::optional<Eigen::Vector3d> WhitenedError(const StereoCamera& camera,
                                             const PointMeasurement& measurement,
                                             const RigidTransform& camera_from_world);

// Estimates the camera pose without an initial guess from measurements that may contain many
// outliers. Each hypothesis is a 3D-3D alignment of three triangulated points. The one with the
// most cubes (without `cubes`, measurements) within the gate, widened for the noise of the sample,
// is refined by RefineCamera. Empty if there is no hypothesis, or if the refined pose has fewer
// than min_inliers inliers.
std::optional<CameraSolution> SolveCameraRansac(const StereoCamera& camera,
                                                std::span<const PointMeasurement> measurements,
                                                const NoiseOptions& noise,
                                                std::span<const int> cubes, int iterations,
                                                int min_inliers, Rng& rng);

}  // namespace cvo
