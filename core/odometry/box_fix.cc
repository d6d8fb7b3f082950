// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/odometry/box_fix.h"

#include <algorithm>

namespace cvo {
namespace {

// Standard deviations in sizes of the body. Across: edges of boxes jitter by some per cent of it.
// Along: how deep a body is behind what is seen of it depends on its shape.
constexpr double kAcross = 0.05;
constexpr double kAlong = 0.3;

}  // namespace

BoxFix FixFromBox(const FrameView& view, const Detection& detection,
                  const Eigen::Vector3d& surface_in_world) {
  const double depth_m = (view.world_from_camera.Inverse() * surface_in_world).z();
  const ImageBox& box = detection.box;
  const Eigen::Vector3d ray_in_camera(
      (0.5 * (box.left_px + box.right_px) - view.camera.cx) / view.camera.fx,
      (0.5 * (box.top_px + box.bottom_px) - view.camera.cy) / view.camera.fy, 1.0);
  BoxFix fix;
  fix.size_m = depth_m * std::min(box.Width() / view.camera.fx, box.Height() / view.camera.fy);
  const double center_m = depth_m + view.options.clusters.birth_depth * fix.size_m;
  fix.center_in_world = view.world_from_camera * (center_m * ray_in_camera);
  const Eigen::Vector3d along =
      view.world_from_camera.rotation() * ray_in_camera.normalized();
  const Eigen::Matrix3d along_only = along * along.transpose();
  const double across_m = kAcross * fix.size_m;
  const double along_m = kAlong * fix.size_m;
  fix.information = along_only / (along_m * along_m) +
                    (Eigen::Matrix3d::Identity() - along_only) / (across_m * across_m);
  return fix;
}

}  // namespace cvo
