// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "core/solvers/schur_equations.h"
#include "core/solvers/window_prior.h"

namespace cvo {

// 1/2 ||r0 + J0 dx||^2 of a WindowPrior for the Schur solver, whose first six other variables are
// right_field_px. `prior` must outlive it; `frame_index`: of the prior's frames in the window.
class SchurPrior {
 public:
  SchurPrior(const WindowPrior& prior, std::vector<int> frame_index);

  double Energy(const std::vector<RigidTransform>& world_from_camera,
                const Vector6d& right_field_px) const;
  // `pose_of_frame`: column of a frame's pose, -1 where it is held; by frame of the window.
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
