// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/odometry/identity.h"

#include <algorithm>
#include <cmath>

namespace cvo {
namespace {

// Origins of a body found twice differ by about this, in sizes of the body.
constexpr double kOriginDeviation = 0.3;
// A prediction does not spread farther than this: bodies turn back, and rooms have walls.
constexpr double kMaxDeviation_m = 1.0;
// The next candidate must be so much farther.
constexpr double kUniqueness = 1.5;

const Cluster& FindCluster(const ClusterMap& map, ClusterId id) {
  for (const Cluster& cluster : map.live) {
    if (cluster.id == id) return cluster;
  }
  const auto it = std::find_if(map.archived.begin(), map.archived.end(),
                               [id](const Cluster& cluster) { return cluster.id == id; });
  Require(it != map.archived.end(),
          "InheritIdentities: a lost cluster is neither live nor archived");
  return *it;
}

// Whether their class and what is given of them let two clusters be one body.
bool MayBeOne(const Cluster& found, const Cluster& lost) {
  const bool is_given = found.given_body >= 0 && lost.given_body >= 0;
  return found.category == lost.category && (!is_given || found.given_body == lost.given_body);
}

double Distance(const Cluster& found, const Cluster& lost, const PredictedCluster& predicted) {
  const double spread = std::min(std::sqrt(predicted.translation_variance_m2), kMaxDeviation_m);
  const double deviation = std::hypot(spread, kOriginDeviation * lost.size_m);
  const Eigen::Vector3d offset =
      found.Latest().world_from_object.translation() - predicted.world_from_object.translation();
  return offset.norm() / deviation;
}

// The one lost cluster that the found one must be; null where there is none or a doubt.
const LostCluster* FindPredecessor(const Cluster& found, const std::vector<LostCluster>& lost,
                                   const ClusterMap& map, double gate) {
  const LostCluster* best = nullptr;
  double nearest = gate;
  double second = std::numeric_limits<double>::infinity();
  for (const LostCluster& candidate : lost) {
    const Cluster& cluster = FindCluster(map, candidate.id);
    if (!MayBeOne(found, cluster)) continue;
    const double distance = Distance(found, cluster, candidate.predicted);
    if (distance < nearest) {
      second = best ? nearest : second;
      nearest = distance;
      best = &candidate;
    } else {
      second = std::min(second, distance);
    }
  }
  return best && second > kUniqueness * nearest ? best : nullptr;
}

// Expresses a cluster and its landmarks in another frame of the same body.
void ChangeFrame(const RigidTransform& old_from_new, ClusterId id, Cluster& cluster,
                 ClusterTrajectory& trajectory) {
  const RigidTransform new_from_old = old_from_new.Inverse();
  const Eigen::Matrix3d R = new_from_old.RotationMatrix();
  for (ClusterState& state : cluster.states) {
    state.world_from_object = state.world_from_object * old_from_new;
  }
  for (ClusterPose& pose : trajectory.poses) {
    pose.world_from_object = pose.world_from_object * old_from_new;
  }
  for (Landmark& landmark : cluster.landmarks) {
    landmark.label.cluster = id;
    landmark.p_in_body = new_from_old * landmark.p_in_body;
    landmark.view_in_body = R * landmark.view_in_body;
    landmark.covariance.in_body_m2 = R * landmark.covariance.in_body_m2 * R.transpose();
    landmark.past_information = R * landmark.past_information * R.transpose();
  }
  cluster.center_in_object = new_from_old * cluster.center_in_object;
}

void Inherit(const LostCluster& lost, ClusterMap& map, Cluster& found) {
  const RigidTransform& now = found.Latest().world_from_object;
  const RigidTransform world_from_lost(
      Eigen::Quaterniond(lost.predicted.world_from_object.rotation()),
      Eigen::Vector3d(now.translation()));
  ClusterTrajectory later = std::move(map.trajectories[found.id]);
  map.trajectories.erase(found.id);
  ChangeFrame(now.Inverse() * world_from_lost, lost.id, found, later);
  found.id = lost.id;
  std::vector<ClusterPose>& poses = map.trajectories[lost.id].poses;
  // While both were live, the lost one was only predicted.
  std::erase_if(poses, [&](const ClusterPose& pose) {
    return !later.poses.empty() && pose.frame >= later.poses.front().frame;
  });
  poses.insert(poses.end(), later.poses.begin(), later.poses.end());
}

void Remove(ClusterId id, FrameId newest, ClusterMap& map) {
  std::erase_if(map.archived, [&](const Cluster& cluster) { return cluster.id == id; });
  std::erase_if(map.live, [&](const Cluster& cluster) {
    return cluster.id == id && cluster.last_observed < newest;
  });
}

}  // namespace

void InheritIdentities(const std::vector<LostCluster>& lost, FrameId newest,
                       const ClusterAssociationOptions& association, const ClusterOptions& options,
                       ClusterMap& map) {
  std::vector<ClusterId> inherited;
  for (Cluster& cluster : map.live) {
    const bool is_just_confirmed =
        IsConfirmed(cluster, options) && cluster.detections == options.confirm_detections &&
        cluster.last_detected == newest && cluster.last_observed == newest;
    if (!is_just_confirmed) continue;
    const LostCluster* predecessor =
        FindPredecessor(cluster, lost, map, association.relocation_gate);
    if (!predecessor) continue;
    if (std::find(inherited.begin(), inherited.end(), predecessor->id) != inherited.end()) continue;
    inherited.push_back(predecessor->id);
    Inherit(*predecessor, map, cluster);
  }
  for (const ClusterId id : inherited) Remove(id, newest, map);
  std::sort(map.live.begin(), map.live.end(),
            [](const Cluster& a, const Cluster& b) { return a.id < b.id; });
}

}  // namespace cvo
