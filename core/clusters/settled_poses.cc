// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/clusters/settled_poses.h"

#include <algorithm>
#include <iterator>

namespace cvo {
namespace {

// Whether the cluster may still be identified as a lost one (IdentityPolicy). This also holds for a
// cluster that is confirmed only by its given body.
bool MayBeAnother(const Cluster& cluster, const ClusterOptions& options) {
  return cluster.detections < options.confirm_detections;
}

// The first frame from which poses of every cluster may still change.
FrameId FirstOpen(const Window& window, const ClusterOptions& options, const ClusterMap& map) {
  FrameId first = window.temporal.front().id;
  for (const Cluster& cluster : map.live) {
    const auto trajectory = map.trajectories.find(cluster.id);
    if (!MayBeAnother(cluster, options) || trajectory == map.trajectories.end()) continue;
    const std::vector<ClusterPose>& poses = trajectory->second.poses;
    if (!poses.empty()) first = std::min(first, FrameId{poses.front().frame});
  }
  return first;
}

// The first frame from which poses of this cluster may still change.
FrameId FirstOpen(const Cluster& cluster, FrameId of_all) {
  const FrameId first = std::min(of_all, cluster.states.front().frame);
  return cluster.former.since.valid() ? std::min(first, cluster.former.since) : first;
}

std::vector<ClusterPose> TakeBefore(FrameId open, ClusterTrajectory& trajectory) {
  const auto end = FirstPoseFrom(open.value, trajectory);
  std::vector<ClusterPose> taken(std::make_move_iterator(trajectory.poses.begin()),
                                 std::make_move_iterator(end));
  trajectory.poses.erase(trajectory.poses.begin(), end);
  return taken;
}

}  // namespace

std::vector<ClusterTrajectory> TakeSettledPoses(const Window& window, const ClusterOptions& options,
                                                ClusterMap& map) {
  std::vector<ClusterTrajectory> settled;
  if (window.temporal.empty()) return settled;
  const FrameId open = FirstOpen(window, options, map);
  for (auto it = map.trajectories.begin(); it != map.trajectories.end();) {
    auto& [id, trajectory] = *it;
    const Cluster* cluster = FindCluster(map, id);
    if (cluster == nullptr || !MayBeAnother(*cluster, options)) {
      std::vector<ClusterPose> poses =
          TakeBefore(cluster == nullptr ? open : FirstOpen(*cluster, open), trajectory);
      if (!poses.empty()) settled.push_back({id, trajectory.category, std::move(poses)});
    }
    const bool is_over = cluster == nullptr && trajectory.poses.empty();
    it = is_over ? map.trajectories.erase(it) : std::next(it);
  }
  return settled;
}

}  // namespace cvo
