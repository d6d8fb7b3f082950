// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "core/geometry/rigid_transform.h"
#include "core/solvers/window_solver.h"

namespace cvo {

using Matrix63d = Eigen::Matrix<double, 6, 3>;
using Matrix36d = Eigen::Matrix<double, 3, 6>;

// Coupling of a point to a free pose by an observation: d^2 E / (d pose d point) = G^T M with
// G = [[lever]_x, -I], where `lever` is the vector from the pose's origin to the point, in world
// axes.
struct PoseCoupling {
  int pose = 0;
  Eigen::Vector3d lever = Eigen::Vector3d::Zero();
  Eigen::Matrix3d M = Eigen::Matrix3d::Zero();
};

// Returns G^T A for the G of PoseCoupling.
inline Matrix63d LeverTransposeTimes(const Eigen::Vector3d& lever, const Eigen::Matrix3d& A) {
  Matrix63d product;
  for (int k = 0; k < 3; ++k) {
    product(0, k) = A(1, k) * lever.z() - A(2, k) * lever.y();
    product(1, k) = A(2, k) * lever.x() - A(0, k) * lever.z();
    product(2, k) = A(0, k) * lever.y() - A(1, k) * lever.x();
    product(3, k) = -A(0, k);
    product(4, k) = -A(1, k);
    product(5, k) = -A(2, k);
  }
  return product;
}

struct PointEquations {
  Eigen::Matrix3d H = Eigen::Matrix3d::Zero();
  Eigen::Vector3d g = Eigen::Vector3d::Zero();
  Matrix36d by_shared = Matrix36d::Zero();  // d^2 E / (d point d shared variables)
};

// Normal equations H dx = -g of an energy over poses (tangent: rotation about world axes applied
// from the left, then translation), a few other variables, and many points. A point is coupled only
// to poses and, if `points_see_shared`, to the first kShared of the other variables.
struct SchurEquations {
  static constexpr int kShared = 6;

  // Observations must be sorted by point, then by ascending pose. `pose_of_frame` is -1 for a pose
  // that is held fixed.
  SchurEquations(const std::vector<int>& pose_of_frame, int others, std::size_t point_count,
                 const std::vector<ReprojectionFactor>& factors);
  void SetZero();
  double LargestGradient() const;
  int others_begin() const { return 6 * static_cast<int>(pose_H.size()); }

  std::vector<Matrix6d> pose_H;  // per pose: block from the observations
  Eigen::MatrixXd H;             // all other terms in poses and others; lower triangle
  Eigen::VectorXd g;
  std::vector<PointEquations> points;
  std::vector<PoseCoupling> couplings;  // sorted by point, then by ascending pose
  std::vector<int> couplings_begin;     // per point, plus the end of the last
  bool points_see_shared = false;
};

struct SchurStep {
  Eigen::VectorXd reduced;  // poses, then others
  std::vector<Eigen::Vector3d> points;
  double expected_decrease = 0.0;  // of the energy, by the undamped quadratic model
  double norm = 0.0;
};

// Adds the energy 1/2 ||r0 + J0 dx||^2 of a WindowPrior to SchurEquations whose first six other
// variables are right_field_px. `prior` must outlive this object. `frame_index` holds the window
// index of each frame of the prior.
class SchurPrior {
 public:
  SchurPrior(const WindowPrior& prior, std::vector<int> frame_index);

  double Energy(const std::vector<RigidTransform>& world_from_camera,
                const Vector6d& right_field_px) const;
  // `pose_of_frame` holds, per frame of the window, the index of its pose in the equations; -1 if
  // the pose is held fixed.
  void AddTo(const std::vector<RigidTransform>& world_from_camera, const Vector6d& right_field_px,
             bool is_right_field_fixed, const std::vector<int>& pose_of_frame,
             SchurEquations& equations) const;

 private:
  Eigen::VectorXd Difference(const std::vector<RigidTransform>& world_from_camera,
                             const Vector6d& right_field_px) const;

  const WindowPrior* prior_;
  std::vector<int> frame_index_;
  Eigen::MatrixXd H0_;  // J0^T J0
};

}  // namespace cvo
