// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ceres/sized_cost_function.h>

#include "core/estimation/reprojection_cost.h"

namespace cvo {

// r = W (pi(camera_from_world world_from_object p_in_object) - z), the camera held: the
// reprojection term of the paper's energy of a cluster, corrected (estimator.md 12, row 1). J_pose
// in the tangent of world_from_object. Near points as in EvaluateReprojection.
struct ObjectReprojectionResidual {
  Eigen::Vector3d r;
  Eigen::Matrix<double, 3, 6> J_pose;
  Eigen::Matrix3d J_point;
};
ObjectReprojectionResidual EvaluateObjectReprojection(const StereoCamera& camera,
                                                      const Eigen::Vector3d& z_px,
                                                      const Eigen::Matrix3d& sqrt_information,
                                                      const RigidTransform& world_from_camera,
                                                      const RigidTransform& world_from_object,
                                                      const Eigen::Vector3d& p_in_object);

// The same for Ceres; blocks: world_from_object (7, PoseManifold), p_in_object (3).
class ObjectReprojectionCost final : public ceres::SizedCostFunction<3, 7, 3> {
 public:
  ObjectReprojectionCost(const StereoCamera& camera, const RigidTransform& world_from_camera,
                         const Eigen::Vector3d& z_px, const Eigen::Matrix3d& sqrt_information)
      : camera_(camera),
        world_from_camera_(world_from_camera),
        z_px_(z_px),
        sqrt_information_(sqrt_information) {}

  bool Evaluate(double const* const* blocks, double* residuals, double** jacobians) const override;

 private:
  StereoCamera camera_;
  RigidTransform world_from_camera_;
  Eigen::Vector3d z_px_;
  Eigen::Matrix3d sqrt_information_;
};

}  // namespace cvo
