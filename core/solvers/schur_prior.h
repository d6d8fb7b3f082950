// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "core/solvers/schur_equations.h"
#include "core/solvers/window_prior.h"

namespace cvo {

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
