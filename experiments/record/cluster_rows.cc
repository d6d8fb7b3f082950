// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/record/cluster_rows.h"

#include <algorithm>
#include <array>
#include <limits>

namespace cvo {
namespace {

// nullptr where the run did not keep one.
const ClusterPose* FindRefined(const RunResult& run, ClusterId id, std::int64_t frame) {
  for (const ClusterTrajectory& cluster : run.clusters) {
    if (cluster.id != id) continue;
    const auto found = std::lower_bound(
        cluster.poses.begin(), cluster.poses.end(), frame,
        [](const ClusterPose& pose, std::int64_t index) { return pose.frame < index; });
    return found != cluster.poses.end() && found->frame == frame ? &*found : nullptr;
  }
  return nullptr;
}

std::array<Eigen::Vector3d, 8> CornersInCamera(const ClusterRow& row) {
  std::array<Eigen::Vector3d, 8> corners;
  for (unsigned i = 0; i < 8; ++i) {
    const Eigen::Vector3d sign((i & 1U) != 0 ? 1.0 : -1.0, (i & 2U) != 0 ? 1.0 : -1.0,
                               (i & 4U) != 0 ? 1.0 : -1.0);
    corners[i] =
        row.CameraFromBox() * Eigen::Vector3d(0.5 * sign.cwiseProduct(row.report.box.size_m));
  }
  return corners;
}

}  // namespace

std::vector<ClusterRow> ClusterRows(const RunResult& run) {
  std::vector<ClusterRow> rows;
  for (std::size_t i = 0; i < run.frames.size(); ++i) {
    const FrameRecord& frame = run.frames[i];
    for (const ClusterReport& report : frame.report.clusters) {
      const ClusterPose* refined = FindRefined(run, report.id, static_cast<std::int64_t>(i));
      const RigidTransform camera_from_world =
          (refined ? frame.refined_world_from_camera : frame.report.world_from_camera).Inverse();
      rows.push_back(
          {frame, report, refined,
           camera_from_world * (refined ? refined->world_from_object : report.world_from_object)});
    }
  }
  return rows;
}

std::optional<ImageBox> ProjectedBox(const ClusterRow& row, const StereoCamera& camera) {
  const std::array<Eigen::Vector3d, 8> corners = CornersInCamera(row);
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  constexpr double kNear_m = 0.1;
  ImageBox box = {kInfinity, kInfinity, -kInfinity, -kInfinity};
  const auto add = [&](const Eigen::Vector3d& p_in_camera) {
    const double u_px = camera.fx * p_in_camera.x() / p_in_camera.z() + camera.cx;
    const double v_px = camera.fy * p_in_camera.y() / p_in_camera.z() + camera.cy;
    box = {std::min(box.left_px, u_px), std::min(box.top_px, v_px), std::max(box.right_px, u_px),
           std::max(box.bottom_px, v_px)};
  };
  // Edges join corners that differ in one bit; those through the near plane end there.
  for (unsigned i = 0; i < 8; ++i) {
    if (corners[i].z() >= kNear_m) add(corners[i]);
    for (const unsigned bit : {1U, 2U, 4U}) {
      const Eigen::Vector3d& a = corners[i];
      const Eigen::Vector3d& b = corners[i | bit];
      if ((a.z() < kNear_m) == (b.z() < kNear_m)) continue;
      add(a + (kNear_m - a.z()) / (b.z() - a.z()) * (b - a));
    }
  }
  const double right_px = camera.width_px - 1;
  const double bottom_px = camera.height_px - 1;
  if (!(box.right_px >= 0.0 && box.bottom_px >= 0.0 && box.left_px <= right_px &&
        box.top_px <= bottom_px)) {
    return std::nullopt;
  }
  return ImageBox{std::max(box.left_px, 0.0), std::max(box.top_px, 0.0),
                  std::min(box.right_px, right_px), std::min(box.bottom_px, bottom_px)};
}

}  // namespace cvo
