// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/solvers/window_prior.h"

namespace cvo {

WindowPrior CalibrationPrior(const StereoCamera& camera, double deviation_px) {
  WindowPrior prior;
  prior.right_shift_point_px = camera.right_shift_px;
  prior.J0 = Eigen::MatrixXd::Constant(1, 1, 1.0 / deviation_px);
  prior.r0 = Eigen::VectorXd::Zero(1);
  return prior;
}

}  // namespace cvo
