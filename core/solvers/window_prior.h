// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/base/ids.h"
#include "core/geometry/rigid_transform.h"
#include "core/geometry/stereo_camera.h"

namespace cvo {

// Prior knowledge of the window, apart from its observations: what marginalised variables said of
// the frames they were connected to, and how far the calibration is trusted. Its energy is
// 1/2 ||r0 + J0 dx||^2, where dx stacks world_from_camera [-] linearization_point of all frames,
// then right_field_px - right_field_point_px (the last term of the paper's static energy; one joint
// term, METHOD.md 7.3).
struct WindowPrior {
  std::vector<FrameId> frames;  // ascending
  std::vector<RigidTransform> linearization_point;
  Vector6d right_field_point_px = Vector6d::Zero();
  Eigen::MatrixXd J0;  // rows x (6 frames + 6)
  Eigen::VectorXd r0;
};

// Makes a prior on the calibration alone:
// right_field_px ~ N(camera.right_field_px, diag(deviation_px)^2).
WindowPrior CalibrationPrior(const StereoCamera& camera, const Vector6d& deviation_px);

}  // namespace cvo
