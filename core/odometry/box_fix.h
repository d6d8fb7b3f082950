// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/odometry/cluster_association.h"

namespace cvo {

// Where a body is, judged by its box and the nearest points in it alone: near its centre.
struct BoxFix {
  Eigen::Vector3d center_in_world = Eigen::Vector3d::Zero();
  double size_m = 0.0;  // smaller side of the box at the body's depth
};

// From the median of the surface points seen in the detection's box: moved away from the camera by
// clusters.birth_depth of the box's smaller side.
BoxFix FixFromSurface(const FrameView& view, const Detection& detection,
                      const Eigen::Vector3d& surface_in_world);

}  // namespace cvo
