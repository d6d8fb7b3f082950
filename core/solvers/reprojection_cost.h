// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include "core/geometry/rigid_transform.h"
#include "core/geometry/stereo_camera.h"

namespace cvo {

// Moves a point that is nearer than StereoCamera::kMinDepth_m to just beyond that depth, so that
// its residual stays finite.
inline Eigen::Vector3d InFront(const Eigen::Vector3d& p_in_camera) {
  return {p_in_camera.x(), p_in_camera.y(),
          std::max(p_in_camera.z(), 1.001 * StereoCamera::kMinDepth_m)};
}

// r = W (pi(p_in_camera) - z), with near points moved by InFront.
inline Eigen::Vector3d EvaluateResidual(const StereoCamera& camera, const Eigen::Vector3d& z_px,
                                        const Eigen::Matrix3d& sqrt_information,
                                        const Eigen::Vector3d& p_in_camera) {
  return sqrt_information * (*camera.Project(InFront(p_in_camera)) - z_px);
}

// The same r, and its 3x3 Jacobian with respect to p_in_camera.
struct ProjectionResidual {
  Eigen::Vector3d r;
  Eigen::Matrix3d J;
  Eigen::Vector3d zeta_px;  // pi(p_in_camera)
};
inline ProjectionResidual EvaluateProjection(const StereoCamera& camera,
                                             const Eigen::Vector3d& z_px,
                                             const Eigen::Matrix3d& sqrt_information,
                                             const Eigen::Vector3d& p_in_camera) {
  const Eigen::Vector3d c = InFront(p_in_camera);
  const Eigen::Vector3d zeta_px = *camera.Project(c);
  return {sqrt_information * (zeta_px - z_px), sqrt_information * camera.ProjectionJacobian(c),
          zeta_px};
}

// r = W (pi(camera_from_world p) - z), the reprojection term of the paper's static energy. J_pose
// (3x6) is in the tangent of world_from_camera, J_point (3x3) is with respect to p_in_world, and
// J_field (3x6) with respect to camera.right_field_px. Near points are moved by InFront.
struct ReprojectionResidual {
  Eigen::Vector3d r;
  Eigen::Matrix<double, 3, 6> J_pose;
  Eigen::Matrix3d J_point;
  Eigen::Matrix<double, 3, 6> J_field;
};
ReprojectionResidual EvaluateReprojection(const StereoCamera& camera, const Eigen::Vector3d& z_px,
                                          const Eigen::Matrix3d& sqrt_information,
                                          const RigidTransform& world_from_camera,
                                          const Eigen::Vector3d& p_in_world);

}  // namespace cvo
