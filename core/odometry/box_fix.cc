// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/odometry/box_fix.h"

#include <algorithm>

namespace cvo {

BoxFix FixFromSurface(const FrameView& view, const Detection& detection,
                      const Eigen::Vector3d& surface_in_world) {
  const Eigen::Vector3d ray = surface_in_world - view.world_from_camera.translation();
  const double range_m = ray.norm();
  const double size_m = range_m * std::min(detection.box.Width() / view.camera.fx,
                                           detection.box.Height() / view.camera.fy);
  return {surface_in_world + view.options.clusters.birth_depth * size_m * ray / range_m, size_m};
}

}  // namespace cvo
