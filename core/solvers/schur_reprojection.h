// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "core/solvers/reprojection_cost.h"
#include "core/solvers/schur_equations.h"
#include "core/solvers/window_solver.h"

namespace cvo {

// A frame of the static window in the form that the inner loops need. Points are in the world and
// move against the camera. With B = d r / d (point in world axes),
// J_pose = kSign B [[lever]_x, -I].
struct CameraView {
  static constexpr double kSign = 1.0;
  int pose = -1;  // index in the equations; -1: held fixed
  Eigen::Matrix3d camera_from_world;
  Eigen::Vector3d position;

  CameraView(int pose_column, const RigidTransform& world_from_camera)
      : pose(pose_column),
        camera_from_world(world_from_camera.RotationMatrix().transpose()),
        position(world_from_camera.translation()) {}
  Eigen::Vector3d Lever(const Eigen::Vector3d& p_in_world) const { return p_in_world - position; }
  Eigen::Vector3d InCamera(const Eigen::Vector3d& lever) const { return camera_from_world * lever; }
  const Eigen::Matrix3d& TimesPointAxes(const Eigen::Matrix3d& N) const { return N; }
  const Eigen::Matrix3d& PointAxesTimes(const Eigen::Matrix3d& N) const { return N; }
  const Eigen::Vector3d& PointAxesTimes(const Eigen::Vector3d& g) const { return g; }
};

// A frame of a cluster: points are in the body frame and move with the body; the camera is held
// fixed.
struct ObjectView {
  static constexpr double kSign = -1.0;
  int pose = -1;
  Eigen::Matrix3d camera_from_world;
  Eigen::Matrix3d world_from_object;
  Eigen::Vector3d offset;  // from the camera to the body's origin, in world

  ObjectView(int pose_column, const RigidTransform& world_from_camera, const RigidTransform& object)
      : pose(pose_column),
        camera_from_world(world_from_camera.RotationMatrix().transpose()),
        world_from_object(object.RotationMatrix()),
        offset(object.translation() - world_from_camera.translation()) {}
  Eigen::Vector3d Lever(const Eigen::Vector3d& p_in_object) const {
    return world_from_object * p_in_object;
  }
  Eigen::Vector3d InCamera(const Eigen::Vector3d& lever) const {
    return camera_from_world * (lever + offset);
  }
  Eigen::Matrix3d TimesPointAxes(const Eigen::Matrix3d& N) const { return N * world_from_object; }
  Eigen::Matrix3d PointAxesTimes(const Eigen::Matrix3d& N) const {
    return world_from_object.transpose() * N;
  }
  Eigen::Vector3d PointAxesTimes(const Eigen::Vector3d& g) const {
    return world_from_object.transpose() * g;
  }
};

// Returns 1/2 sum rho(||W (pi(p_in_camera) - z)||^2) over the factors; `views` holds one per frame.
template <typename View>
double ReprojectionEnergy(const StereoCamera& camera, const std::vector<View>& views,
                          const std::vector<Eigen::Vector3d>& points,
                          const std::vector<ReprojectionFactor>& factors, double huber) {
  double energy = 0.0;
  for (const ReprojectionFactor& factor : factors) {
    const View& view = views[factor.pose];
    const Eigen::Vector3d c = view.InCamera(view.Lever(points[factor.point]));
    const Eigen::Vector3d r = EvaluateResidual(camera, factor.z_px, factor.sqrt_information, c);
    energy += HuberLoss(r.squaredNorm(), huber);
  }
  return 0.5 * energy;
}

// One factor after the robust loss: N = B^T B and g = B^T r, in world axes. The Jacobian with
// respect to the shared variables is W e_3 basis^T, and u = B^T W e_3.
struct WeightedFactor {
  Eigen::Vector3d lever;
  Eigen::Matrix3d N;
  Eigen::Vector3d g;
  Eigen::Vector3d u;
  Vector6d basis;
};

inline void AddToPose(int pose, double sign, const WeightedFactor& factor,
                      SchurEquations& equations) {
  const Eigen::Vector3d& lever = factor.lever;
  const Matrix63d E = LeverTransposeTimes(lever, factor.N);
  Matrix6d& H = equations.pose_H[pose];
  H.col(0) += E.col(1) * lever.z() - E.col(2) * lever.y();
  H.col(1) += E.col(2) * lever.x() - E.col(0) * lever.z();
  H.col(2) += E.col(0) * lever.y() - E.col(1) * lever.x();
  H.bottomRightCorner<3, 3>() += factor.N;
  equations.g.segment<3>(6 * pose) += sign * factor.g.cross(lever);
  equations.g.segment<3>(6 * pose + 3) -= sign * factor.g;
  if (!equations.points_see_shared) return;
  Vector6d by_pose;
  by_pose << sign * factor.u.cross(lever), -sign * factor.u;
  equations.H.block<6, 6>(equations.others_begin(), 6 * pose).noalias() +=
      factor.basis * by_pose.transpose();
}

// Adds a factor's terms in the shared variables, right_field_px.
inline void AddToShared(const Eigen::Vector3d& J_shift, double weight, const Eigen::Vector3d& r,
                        const Vector6d& basis, SchurEquations& equations) {
  const int shared = equations.others_begin();
  equations.H.block<6, 6>(shared, shared).noalias() +=
      (weight * J_shift.squaredNorm()) * basis * basis.transpose();
  equations.g.segment<6>(shared) += weight * J_shift.dot(r) * basis;
}

// Adds the factors to the equations and sets the couplings; returns ReprojectionEnergy.
template <typename View>
double LinearizeReprojections(const StereoCamera& camera, const std::vector<View>& views,
                              const std::vector<Eigen::Vector3d>& points,
                              const std::vector<ReprojectionFactor>& factors, double huber,
                              SchurEquations& equations) {
  double energy = 0.0;
  std::size_t next = 0;  // index of the next coupling
  WeightedFactor weighted;
  for (const ReprojectionFactor& factor : factors) {
    const View& view = views[factor.pose];
    weighted.lever = view.Lever(points[factor.point]);
    const auto [r, J, zeta_px] = EvaluateProjection(camera, factor.z_px, factor.sqrt_information,
                                                    view.InCamera(weighted.lever));
    const double squared_norm = r.squaredNorm();
    energy += HuberLoss(squared_norm, huber);
    const double weight = HuberWeight(squared_norm, huber);
    const Eigen::Matrix3d B = J * view.camera_from_world;
    const Eigen::Matrix3d B_weighted = weight * B;
    weighted.N.noalias() = B_weighted.transpose() * B;
    weighted.g.noalias() = B_weighted.transpose() * r;
    const Eigen::Matrix3d coupling = view.TimesPointAxes(weighted.N);
    PointEquations& point = equations.points[factor.point];
    point.H += view.PointAxesTimes(coupling);
    point.g += view.PointAxesTimes(weighted.g);
    if (equations.points_see_shared) {
      const Eigen::Vector3d J_shift = factor.sqrt_information.col(2);
      weighted.u.noalias() = B_weighted.transpose() * J_shift;
      weighted.basis = camera.BasisAt(zeta_px[0], zeta_px[1]).value;
      point.by_shared.noalias() += view.PointAxesTimes(weighted.u) * weighted.basis.transpose();
      AddToShared(J_shift, weight, r, weighted.basis, equations);
    }
    if (view.pose < 0) continue;
    AddToPose(view.pose, View::kSign, weighted, equations);
    equations.couplings[next++] = {view.pose, weighted.lever, View::kSign * coupling};
  }
  return 0.5 * energy;
}

}  // namespace cvo
