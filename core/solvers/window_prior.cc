// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/solvers/window_prior.h"

namespace cvo {

WindowPrior CalibrationPrior(const StereoCamera& camera, const Vector6d& deviation_px) {
  WindowPrior prior;
  prior.right_field_point_px = camera.right_field_px;
  prior.J0 = deviation_px.cwiseInverse().asDiagonal();
  prior.r0 = Eigen::VectorXd::Zero(deviation_px.size());
  return prior;
}

}  // namespace cvo
