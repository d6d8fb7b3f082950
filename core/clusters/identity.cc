// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/clusters/identity.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <span>

#include "core/association/matching.h"
#include "core/estimation/camera_solver.h"

namespace cvo {

namespace {

// Number of frames in which a new cluster is compared with lost ones: half a second at 30 Hz (not
// swept).
constexpr int kCompareFrames = 15;

// Maximum distance of the lost cluster from its predicted position, in standard deviations of the
// prediction: cars of one model share their landmarks, but no car jumps.
constexpr double kGate = 3.0;

// Whether two clusters may be the same body, judged by class and given body.
bool MayBeOne(const Cluster& found, const Cluster& lost) {
  const bool are_given = found.given_body.valid() && lost.given_body.valid();
  return found.category == lost.category && (!are_given || found.given_body == lost.given_body);
}

bool IsEstimated(const ClusterState&) { return true; }
bool IsEstimated(const ClusterPose& pose) { return pose.status == ClusterStatus::kTracked; }

// Angular velocity of the body at its i-th pose, in world, rad/s. Predicted poses say nothing about
// it: those after a cluster's first state repeat its rotation.
template <typename Pose>
Eigen::Vector3d TurnRate(std::span<const Pose> poses, std::size_t i) {
  const auto is_estimated = [](const Pose& pose) { return IsEstimated(pose); };
  const auto earlier = poses.first(i);
  const auto later = poses.subspan(i + 1);
  const auto last = std::find_if(earlier.rbegin(), earlier.rend(), is_estimated);
  const auto next = std::find_if(later.begin(), later.end(), is_estimated);
  const Pose& before = last != earlier.rend() ? *last : poses[i];
  const Pose& after = next != later.end() ? *next : poses[i];
  if (before.timestamp_ns == after.timestamp_ns) return Eigen::Vector3d::Zero();
  return LogSo3(Eigen::Quaterniond(after.world_from_object.rotation() *
                                   before.world_from_object.rotation().conjugate())) /
         SecondsBetween(before.timestamp_ns, after.timestamp_ns);
}

// Expresses a body's poses, and the velocities of its origin, in another frame of the same body.
template <typename Pose>
void ChangeFrameOfPoses(const RigidTransform& old_from_new, std::span<Pose> poses) {
  std::vector<Eigen::Vector3d> rates;  // before the poses change
  for (std::size_t i = 0; i < poses.size(); ++i) {
    rates.push_back(TurnRate(std::span<const Pose>(poses), i));
  }
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const Eigen::Vector3d lever =
        poses[i].world_from_object.rotation() * Eigen::Vector3d(old_from_new.translation());
    poses[i].velocity_m_s += rates[i].cross(lever);
    poses[i].world_from_object = poses[i].world_from_object * old_from_new;
  }
}

// Expresses a cluster, its landmarks and its trajectory in another frame of the same body, and
// gives them the id `id`.
void ChangeFrame(const RigidTransform& old_from_new, ClusterId id, Cluster& cluster,
                 ClusterTrajectory& trajectory) {
  const RigidTransform new_from_old = old_from_new.Inverse();
  const Eigen::Matrix3d R = new_from_old.RotationMatrix();
  ChangeFrameOfPoses(old_from_new, std::span(cluster.states));
  ChangeFrameOfPoses(old_from_new, std::span(trajectory.poses));
  for (ClusterPose& pose : trajectory.poses) {
    pose.id = id;
    pose.center_in_object = new_from_old * pose.center_in_object;
    pose.box.object_from_box = new_from_old * pose.box.object_from_box;
  }
  for (Landmark& landmark : cluster.landmarks) {
    landmark.label.cluster = id;
    landmark.p_in_object = new_from_old * landmark.p_in_object;
    landmark.covariance.in_object_m2 = R * landmark.covariance.in_object_m2 * R.transpose();
    landmark.past_information = R * landmark.past_information * R.transpose();
    landmark.past_mean_in_object = new_from_old * landmark.past_mean_in_object;
  }
  cluster.id = id;
  cluster.center_in_object = new_from_old * cluster.center_in_object;
}

// Estimates lost_from_found from landmarks with similar descriptors, which are points of both
// clusters; three of them determine it.
std::optional<RigidTransform> AlignLandmarks(int min_pairs, const Cluster& lost,
                                             const Cluster& found, Rng& rng) {
  std::vector<Descriptor> descriptors;
  for (const Landmark& landmark : lost.landmarks) descriptors.push_back(landmark.descriptor);
  std::vector<StereoFeature> features;
  for (const Landmark& landmark : found.landmarks) {
    StereoFeature feature;
    feature.descriptor = landmark.descriptor;
    features.push_back(feature);
  }
  const std::vector<Match> matches =
      MatchDescriptors(descriptors, features, kRematchHamming, kRematchRatio);
  Eigen::Matrix3Xd from(3, static_cast<Eigen::Index>(matches.size()));
  Eigen::Matrix3Xd to = from;
  for (std::size_t i = 0; i < matches.size(); ++i) {
    const Eigen::Index column = static_cast<Eigen::Index>(i);
    from.col(column) = found.landmarks[matches[i].feature].p_in_object;
    to.col(column) = lost.landmarks[matches[i].landmark].p_in_object;
  }
  const int most = static_cast<int>(matches.size()) / 2 + 1;
  return AlignPointsRansac(from, to, PointDeviation_m(found), std::max(min_pairs, most),
                           kRansacIterations, rng);
}

void Inherit(const Cluster& lost, const RigidTransform& lost_from_found, ClusterMap& map,
             Cluster& found) {
  ClusterTrajectory later = std::move(map.trajectories[found.id]);
  map.trajectories.erase(found.id);
  ChangeFrame(lost_from_found.Inverse(), lost.id, found, later);
  for (Landmark landmark : lost.landmarks) {
    landmark.observations.clear();
    if (!landmark.past_information.isZero()) found.landmarks.push_back(std::move(landmark));
  }
  std::ranges::sort(found.landmarks, {}, &Landmark::id);
  std::vector<ClusterPose>& poses = map.trajectories[lost.id].poses;
  // While both clusters were live, the lost one was only predicted; drop those poses.
  std::erase_if(poses, [&](const ClusterPose& pose) {
    return !later.poses.empty() && pose.frame >= later.poses.front().frame;
  });
  poses.insert(poses.end(), later.poses.begin(), later.poses.end());
}

// Whether the lost cluster can have moved to where the alignment places it now. The alignment
// itself is as uncertain as the points that it compares.
bool IsReachable(const PredictedCluster& lost, const Cluster& found,
                 const RigidTransform& lost_from_found) {
  const RigidTransform world_from_lost =
      found.Latest().world_from_object * lost_from_found.Inverse();
  const double deviation_m =
      std::hypot(std::sqrt(lost.translation_variance_m2), PointDeviation_m(found));
  return (world_from_lost.translation() - lost.world_from_object.translation()).norm() <=
         kGate * deviation_m;
}

// The confirmed clusters that are not observed in the newest frame, the last one lost first.
std::vector<const Cluster*> LostClusters(const IdentityStep& step, const ClusterMap& map) {
  std::vector<const Cluster*> lost;
  const auto add = [&](const Cluster& cluster) {
    if (cluster.last_observed < step.newest && IsConfirmed(cluster, step.options.clusters)) {
      lost.push_back(&cluster);
    }
  };
  std::ranges::for_each(map.live, add);
  std::ranges::for_each(map.archived, add);
  std::ranges::stable_sort(lost, std::greater(), &Cluster::last_observed);
  return lost;
}

void Remove(ClusterId id, FrameId newest, ClusterMap& map) {
  std::erase_if(map.archived, [&](const Cluster& cluster) { return cluster.id == id; });
  std::erase_if(map.live, [&](const Cluster& cluster) {
    return cluster.id == id && cluster.last_observed < newest;
  });
}

}  // namespace

void InheritLostIdentity::Update(const IdentityStep& step, ClusterMap& map, Rng& rng) {
  const std::vector<const Cluster*> lost_clusters = LostClusters(step, map);
  std::vector<ClusterId> inherited;
  for (Cluster& found : map.live) {
    const bool is_new = found.frames <= kCompareFrames && found.last_observed == step.newest;
    if (!is_new || !IsConfirmed(found, step.options.clusters)) continue;
    for (const Cluster* lost : lost_clusters) {
      if (!MayBeOne(found, *lost) || std::ranges::count(inherited, lost->id) > 0) continue;
      const auto lost_from_found =
          AlignLandmarks(step.options.association.min_rematch, *lost, found, rng);
      if (!lost_from_found || !IsReachable(step.predict(*lost), found, *lost_from_found)) continue;
      inherited.push_back(lost->id);
      Inherit(*lost, *lost_from_found, map, found);
      break;
    }
  }
  for (const ClusterId id : inherited) Remove(id, step.newest, map);
  std::ranges::sort(map.live, {}, &Cluster::id);
}

}  // namespace cvo
