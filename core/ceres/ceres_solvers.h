// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ceres/manifold.h>
#include <ceres/sized_cost_function.h>

#include <array>

#include "core/solvers/cluster_solver.h"
#include "core/solvers/motion_prior.h"
#include "core/solvers/reprojection_cost.h"
#include "core/solvers/window_solver.h"

namespace cvo::ceres_costs {

// RigidTransform::Plus and Minus as a Ceres manifold. The costs below write their Jacobians with
// respect to the tangent into the first six of the block's seven columns, so PlusJacobian is
// [I6; 0] (METHOD.md 7.5). Tools that differentiate these blocks with respect to the ambient space
// therefore give wrong results.
class PoseManifold final : public ceres::Manifold {
 public:
  int AmbientSize() const override { return 7; }
  int TangentSize() const override { return 6; }
  bool Plus(const double* x, const double* delta, double* x_plus_delta) const override;
  bool PlusJacobian(const double* x, double* jacobian) const override;
  bool Minus(const double* y, const double* x, double* y_minus_x) const override;
  bool MinusJacobian(const double* x, double* jacobian) const override;
};

RigidTransform PoseFromBlock(const double* block);  // [qx qy qz qw tx ty tz]

// Cost of EvaluateReprojection. Blocks: world_from_camera (7, PoseManifold), p_in_world (3),
// right_field_px (6), which replaces that of the camera.
class ReprojectionCost final : public ceres::SizedCostFunction<3, 7, 3, 6> {
 public:
  ReprojectionCost(const StereoCamera& camera, const Eigen::Vector3d& z_px,
                   const Eigen::Matrix3d& sqrt_information)
      : camera_(camera), z_px_(z_px), sqrt_information_(sqrt_information) {}

  bool Evaluate(double const* const* blocks, double* residuals, double** jacobians) const override;

 private:
  StereoCamera camera_;
  Eigen::Vector3d z_px_;
  Eigen::Matrix3d sqrt_information_;
};

// Cost of a WindowPrior, r = r0 + J0 dx. Blocks: one pose (7, PoseManifold) per frame, in the
// prior's order, then right_field_px (6). The rotational part of the tangent is differentiated
// exactly (inverse right Jacobian). `prior` must outlive this object.
class PriorCost final : public ceres::CostFunction {
 public:
  explicit PriorCost(const WindowPrior& prior);
  bool Evaluate(double const* const* blocks, double* residuals, double** jacobians) const override;

 private:
  const WindowPrior* prior_;
};

// r = W (pi(camera_from_world world_from_object p_in_object) - z) with the camera held fixed: the
// reprojection term of the paper's energy of a cluster, corrected (METHOD.md 9). J_pose is in the
// tangent of world_from_object. Near points are treated as in EvaluateReprojection.
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

// Cost of EvaluateObjectReprojection. Blocks: world_from_object (7, PoseManifold), p_in_object (3).
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

// Cost of a PointPrior, r = sqrt_information (p - mean). Block: p_in_object (3). `prior` must
// outlive this object.
class PointPriorCost final : public ceres::SizedCostFunction<3, 3> {
 public:
  explicit PointPriorCost(const PointPrior& prior) : prior_(&prior) {}

  bool Evaluate(double const* const* blocks, double* residuals, double** jacobians) const override {
    const Eigen::Map<const Eigen::Vector3d> p_in_object(blocks[0]);
    Eigen::Map<Eigen::Vector3d> r(residuals);
    r = prior_->sqrt_information * (p_in_object - prior_->mean_in_object);
    if (jacobians && jacobians[0]) {
      Eigen::Map<Eigen::Matrix<double, 3, 3, Eigen::RowMajor>> J(jacobians[0]);
      J = prior_->sqrt_information;
    }
    return true;
  }

 private:
  const PointPrior* prior_;
};

// Cost of EvaluateMotionPrior. Blocks: world_from_object (7, PoseManifold) and velocity (3) of a
// state, then both of the next state.
class MotionPriorCost final : public ceres::SizedCostFunction<6, 7, 3, 7, 3> {
 public:
  explicit MotionPriorCost(const MotionPriorFactors& factors) : factors_(factors) {}

  bool Evaluate(double const* const* blocks, double* residuals, double** jacobians) const override;

 private:
  MotionPriorFactors factors_;
};

// Cost of EvaluateTurnPrior. Blocks: world_from_object (7, PoseManifold) of three consecutive
// frames.
class TurnPriorCost final : public ceres::SizedCostFunction<3, 7, 7, 7> {
 public:
  TurnPriorCost(double power_density_rad2_s3, const std::array<double, 2>& dt_s)
      : power_density_rad2_s3_(power_density_rad2_s3), dt_s_(dt_s) {}

  bool Evaluate(double const* const* blocks, double* residuals, double** jacobians) const override;

 private:
  double power_density_rad2_s3_;
  std::array<double, 2> dt_s_;
};

}  // namespace cvo::ceres_costs

namespace cvo {

// Policy (SolverPolicy): minimises the same energies with the Ceres library: dense Schur
// complement, one thread, the same limits.
struct CeresSolver {
  static SolverSummary Solve(const NoiseOptions& noise, const SolverOptions& options,
                             WindowProblem& problem);
  static SolverSummary Solve(const NoiseOptions& noise, const SolverOptions& options,
                             const MotionPriorSteps& steps, ClusterProblem& problem);
};

}  // namespace cvo
