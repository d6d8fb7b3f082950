// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/base/ids.h"
#include "core/geometry/rigid_transform.h"

namespace cvo {

// What marginalised variables still say of the frames they were connected to: the energy
// 1/2 ||r0 + J0 dx||^2, dx = stacked world_from_camera [-] linearization_point of the frames
// (the last term of the paper's static energy; one joint term, estimator.md 4.2).
struct PosePrior {
  std::vector<FrameId> frames;  // ascending
  std::vector<RigidTransform> linearization_point;
  Eigen::MatrixXd J0;  // rows x 6 frames
  Eigen::VectorXd r0;

  bool empty() const { return frames.empty(); }
};

}  // namespace cvo
