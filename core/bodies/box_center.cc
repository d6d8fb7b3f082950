// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/bodies/box_center.h"

#include <algorithm>
#include <cmath>

namespace cvo {
namespace {

constexpr double kLeastSize_m = 0.01;  // below any real box; keeps the information finite

bool MayBeHidden(const FrameView& view, double max_overlap, int detection) {
  const ImageBox& box = view.shown.detections[detection].box;
  for (int m = 0; m < static_cast<int>(view.shown.detections.size()); ++m) {
    const ImageBox& other = view.shown.detections[m].box;
    const double width_px =
        std::min(box.right_px, other.right_px) - std::max(box.left_px, other.left_px);
    const double height_px =
        std::min(box.bottom_px, other.bottom_px) - std::max(box.top_px, other.top_px);
    if (m == detection || width_px <= 0.0 || height_px <= 0.0) continue;
    if (width_px * height_px > max_overlap * box.Width() * box.Height()) return true;
  }
  return false;
}

// Directions in which an edge of a detection's box may not be the body's own.
struct UnseenEdges {
  bool across = false;  // left or right
  bool down = false;    // top or bottom
};

UnseenEdges UnseenOf(const FrameView& view, const BoxCenterOptions& options, int detection) {
  const bool is_hidden = MayBeHidden(view, options.max_overlap, detection);
  const CutEdges cut = CutBy(view.camera, options.border_px, view.shown.detections[detection].box);
  return {is_hidden || cut.left || cut.right, is_hidden || cut.top || cut.bottom};
}

Eigen::Vector3d Deviations(const BoxCenterOptions& options, const UnseenEdges& unseen,
                           double size_m) {
  return size_m * Eigen::Vector3d(unseen.across ? options.unseen_deviation : options.edge_deviation,
                                  unseen.down ? options.unseen_deviation : options.edge_deviation,
                                  options.unseen_deviation);
}

}  // namespace

CutEdges CutBy(const StereoCamera& camera, double border_px, const ImageBox& box) {
  const double last_u_px = camera.width_px - 1 - border_px;
  const double last_v_px = camera.height_px - 1 - border_px;
  CutEdges cut;
  cut.left = box.left_px < border_px;
  cut.top = box.top_px < border_px;
  cut.right = box.right_px > last_u_px;
  cut.bottom = box.bottom_px > last_v_px;
  return cut;
}

Eigen::Vector3d CenterDeviations(const FrameView& view, const BoxCenterOptions& options,
                                 int detection, double size_m) {
  return Deviations(options, UnseenOf(view, options, detection), size_m);
}

Eigen::Matrix3d InformationAlong(const RigidTransform& world_from_camera,
                                 const Eigen::Vector3d& ray, const Eigen::Vector3d& deviations_m) {
  // Axes of a camera that looks along the ray.
  const Eigen::Matrix3d R =
      world_from_camera.RotationMatrix() *
      Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), ray).toRotationMatrix();
  return R * deviations_m.cwiseAbs2().cwiseInverse().asDiagonal() * R.transpose();
}

BoxCenter CenterFromBox(const FrameView& view, const BoxCenterOptions& options, double birth_depth,
                        int detection, const Eigen::Vector3d& surface_in_world) {
  const ImageBox& box = view.shown.detections[detection].box;
  const double surface_m = (view.world_from_camera.Inverse() * surface_in_world).z();
  const Eigen::Vector3d ray((0.5 * (box.left_px + box.right_px) - view.camera.cx) / view.camera.fx,
                            (0.5 * (box.top_px + box.bottom_px) - view.camera.cy) / view.camera.fy,
                            1.0);
  BoxCenter result;
  result.size_m = std::max(kLeastSize_m, surface_m * std::min(box.Width() / view.camera.fx,
                                                              box.Height() / view.camera.fy));
  const double center_m = surface_m + birth_depth * result.size_m;
  result.center_in_world = view.world_from_camera * (center_m * ray);
  const UnseenEdges unseen = UnseenOf(view, options, detection);
  result.information =
      InformationAlong(view.world_from_camera, ray, Deviations(options, unseen, result.size_m));
  result.is_whole = !unseen.across && !unseen.down;
  return result;
}

}  // namespace cvo
