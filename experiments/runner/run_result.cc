// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/runner/run_result.h"

#include <algorithm>
#include <array>
#include <limits>
#include <map>

#include "core/base/error.h"

namespace cvo {

namespace {

std::array<Eigen::Vector3d, 8> CornersInCamera(const LiveCluster& row) {
  std::array<Eigen::Vector3d, 8> corners;
  for (unsigned i = 0; i < 8; ++i) {
    const Eigen::Vector3d sign((i & 1U) != 0 ? 1.0 : -1.0, (i & 2U) != 0 ? 1.0 : -1.0,
                               (i & 4U) != 0 ? 1.0 : -1.0);
    corners[i] =
        row.CameraFromBox() * Eigen::Vector3d(0.5 * sign.cwiseProduct(row.Last().box.size_m));
  }
  return corners;
}

}  // namespace

RigidTransform LiveCluster::CameraFromBox() const {
  const RigidTransform& world_from_camera =
      refined ? frame.refined_world_from_camera : frame.report.world_from_camera;
  return world_from_camera.Inverse() * Last().world_from_object * Last().box.object_from_box;
}

void ForEachLiveCluster(const RunResult& run, const std::function<void(const LiveCluster&)>& take) {
  std::vector<std::map<ClusterId, const ClusterPose*>> refined(run.frames.size());
  for (const ClusterTrajectory& cluster : run.clusters) {
    for (const ClusterPose& pose : cluster.poses) {
      refined.at(static_cast<std::size_t>(pose.frame))[cluster.id] = &pose;
    }
  }
  for (std::size_t i = 0; i < run.frames.size(); ++i) {
    const FrameRecord& frame = run.frames[i];
    std::map<ClusterId, LiveCluster> rows;
    const auto row = [&](ClusterId id) -> LiveCluster& {
      return rows.try_emplace(id, LiveCluster{frame, id}).first->second;
    };
    for (const ClusterReport& report : frame.report.clusters) row(report.id).causal = &report;
    for (const auto& [id, pose] : refined[i]) row(id).refined = pose;
    for (const auto& [id, row_of_id] : rows) take(row_of_id);
  }
}

std::optional<ImageBox> ProjectedBox(const LiveCluster& row, const StereoCamera& camera) {
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
  // Edges connect corners whose indices differ in one bit. An edge through the near plane is cut
  // there.
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

const char* ToString(RunStatus status) {
  switch (status) {
    case RunStatus::kOk:
      return "ok";
    case RunStatus::kLost:
      return "lost";
    case RunStatus::kFailed:
      return "failed";
  }
  throw Error("RunStatus: not one of the enumerators");
}

}  // namespace cvo
