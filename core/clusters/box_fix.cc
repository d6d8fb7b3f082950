// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/clusters/box_fix.h"

#include <algorithm>
#include <cmath>

namespace cvo {
namespace {

// Standard deviations of the centre in sizes of the body. Between two edges of a box that is whole:
// they jitter by some per cent. Along the line of sight and where an edge is not the body's: how
// far it reaches there depends on its shape.
constexpr double kBetweenEdges = 0.05;
constexpr double kUnknown = 0.3;
// Edges nearer to the border of the image may be cut by it.
constexpr double kBorder_px = 3.0;
// Share of a box that another one overlaps from which on it may hide part of the body.
constexpr double kHidden = 0.05;
constexpr double kLeastSize_m = 0.01;

bool MayBeHidden(const FrameView& view, int detection) {
  const ImageBox& box = view.detections[detection].box;
  for (int m = 0; m < static_cast<int>(view.detections.size()); ++m) {
    const ImageBox& other = view.detections[m].box;
    const double width_px =
        std::min(box.right_px, other.right_px) - std::max(box.left_px, other.left_px);
    const double height_px =
        std::min(box.bottom_px, other.bottom_px) - std::max(box.top_px, other.top_px);
    if (m == detection || width_px <= 0.0 || height_px <= 0.0) continue;
    if (width_px * height_px > kHidden * box.Width() * box.Height()) return true;
  }
  return false;
}

// Along the axes of the camera.
Eigen::Vector3d Deviations(const FrameView& view, int detection, double size_m) {
  const ImageBox& box = view.detections[detection].box;
  const bool is_hidden = MayBeHidden(view, detection);
  const auto of_edges = [&](double low_px, double high_px, int image_px) {
    const bool is_cut = low_px < kBorder_px || high_px > image_px - 1 - kBorder_px;
    return size_m * (is_cut || is_hidden ? kUnknown : kBetweenEdges);
  };
  return {of_edges(box.left_px, box.right_px, view.camera.width_px),
          of_edges(box.top_px, box.bottom_px, view.camera.height_px), size_m * kUnknown};
}

}  // namespace

BoxFix FixFromBox(const FrameView& view, int detection, const Eigen::Vector3d& surface_in_world) {
  const ImageBox& box = view.detections[detection].box;
  const double surface_m = (view.world_from_camera.Inverse() * surface_in_world).z();
  const Eigen::Vector3d ray((0.5 * (box.left_px + box.right_px) - view.camera.cx) / view.camera.fx,
                            (0.5 * (box.top_px + box.bottom_px) - view.camera.cy) / view.camera.fy,
                            1.0);
  BoxFix fix;
  fix.size_m = std::max(kLeastSize_m, surface_m * std::min(box.Width() / view.camera.fx,
                                                           box.Height() / view.camera.fy));
  const double center_m = surface_m + view.options.clusters.birth_depth * fix.size_m;
  fix.center_in_world = view.world_from_camera * (center_m * ray);
  // Of the axes of a camera that looks along the ray.
  const Eigen::Matrix3d R =
      view.world_from_camera.RotationMatrix() *
      Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), ray).toRotationMatrix();
  fix.information =
      R * Deviations(view, detection, fix.size_m).cwiseAbs2().cwiseInverse().asDiagonal() *
      R.transpose();
  return fix;
}

}  // namespace cvo
