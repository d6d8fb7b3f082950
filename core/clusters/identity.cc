// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/clusters/identity.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/association/descriptor_matching.h"
#include "core/estimation/point_ransac.h"

namespace cvo {
namespace {

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
  const bool is_given = found.given_body.valid() && lost.given_body.valid();
  return found.category == lost.category && (!is_given || found.given_body == lost.given_body);
}

// How badly a lost cluster explains where the found one's centre is, and its size: minus the
// logarithm of the probability density, 1/m^3. What may be anywhere is a poor explanation.
double ExplanationEnergy(const Cluster& found, const Cluster& lost,
                         const PredictedCluster& predicted, const IdentityOptions& options) {
  const double spread =
      std::min(std::sqrt(predicted.translation_variance_m2), options.max_spread_m);
  const double deviation = std::hypot(spread, options.center_deviation * lost.size_m);
  const Eigen::Vector3d offset = found.Latest().world_from_object * found.box_center.InObject() -
                                 predicted.world_from_object * lost.box_center.InObject();
  // A body that given labels alone told of has no size.
  const bool has_size = found.size_m > 0.0 && lost.size_m > 0.0;
  const double size =
      has_size ? std::log(found.size_m / lost.size_m) / std::log(options.size_factor) : 0.0;
  return 0.5 * (offset.squaredNorm() / (deviation * deviation) + size * size) +
         3.0 * std::log(deviation);
}

// The one lost cluster that the found one must be; null where there is none or a doubt.
const LostCluster* FindPredecessor(const Cluster& found, const std::vector<LostCluster>& lost,
                                   const ClusterMap& map, const IdentityOptions& options) {
  const LostCluster* best = nullptr;
  double least = 0.5 * options.gate * options.gate;
  double second = std::numeric_limits<double>::infinity();
  for (const LostCluster& candidate : lost) {
    const Cluster& cluster = FindCluster(map, candidate.id);
    if (!MayBeOne(found, cluster)) continue;
    if (found.given_body.valid()) return &candidate;
    const double energy = ExplanationEnergy(found, cluster, candidate.predicted, options);
    if (energy < least) {
      if (best) second = least;
      least = energy;
      best = &candidate;
    } else {
      second = std::min(second, energy);
    }
  }
  return second - least > options.min_lead ? best : nullptr;
}

// How fast the body turns, in world, at each of its poses from the first one on, rad/s.
template <typename Pose>
std::vector<Eigen::Vector3d> TurnRates(const std::vector<Pose>& poses, std::size_t first) {
  std::vector<Eigen::Vector3d> rates(poses.size(), Eigen::Vector3d::Zero());
  for (std::size_t i = first; i < poses.size(); ++i) {
    const Pose& before = poses[i > first ? i - 1 : i];
    const Pose& after = poses[i + 1 < poses.size() ? i + 1 : i];
    if (before.timestamp_ns == after.timestamp_ns) continue;
    rates[i] = LogSo3(Eigen::Quaterniond(after.world_from_object.rotation() *
                                         before.world_from_object.rotation().conjugate())) /
               SecondsBetween(before.timestamp_ns, after.timestamp_ns);
  }
  return rates;
}

// Poses of a body and velocities of its origin, from the first one on, in another frame of it.
template <typename Pose>
void ChangeFrameOfPoses(const RigidTransform& old_from_new, std::size_t first,
                        std::vector<Pose>& poses) {
  const std::vector<Eigen::Vector3d> rates = TurnRates(poses, first);
  for (std::size_t i = first; i < poses.size(); ++i) {
    const Eigen::Vector3d lever =
        poses[i].world_from_object.rotation() * Eigen::Vector3d(old_from_new.translation());
    poses[i].velocity_m_s += rates[i].cross(lever);
    poses[i].world_from_object = poses[i].world_from_object * old_from_new;
  }
}

// Expresses a cluster and its landmarks in another frame of the same body.
void ChangeFrame(const RigidTransform& old_from_new, ClusterId id, Cluster& cluster,
                 ClusterTrajectory& trajectory) {
  const RigidTransform new_from_old = old_from_new.Inverse();
  const Eigen::Matrix3d R = new_from_old.RotationMatrix();
  ChangeFrameOfPoses(old_from_new, 0, cluster.states);
  // Poses before the cluster was lost stay.
  const auto first = FirstPoseFrom(cluster.former.since.value, trajectory);
  ChangeFrameOfPoses(old_from_new, static_cast<std::size_t>(first - trajectory.poses.begin()),
                     trajectory.poses);
  std::for_each(first, trajectory.poses.end(), [&](ClusterPose& pose) {
    pose.id = id;
    pose.center_in_object = new_from_old * pose.center_in_object;
    pose.box.object_from_box = new_from_old * pose.box.object_from_box;
  });
  for (Landmark& landmark : cluster.landmarks) {
    landmark.label.cluster = id;
    landmark.p_in_object = new_from_old * landmark.p_in_object;
    landmark.view_in_object = R * landmark.view_in_object;
    landmark.covariance.in_object_m2 = R * landmark.covariance.in_object_m2 * R.transpose();
    landmark.past_information = R * landmark.past_information * R.transpose();
    landmark.past_mean_in_object = new_from_old * landmark.past_mean_in_object;
  }
  cluster.center_in_object = new_from_old * cluster.center_in_object;
  cluster.box_center = cluster.box_center.In(new_from_old);
}

// former_from_now from landmarks that look alike: points of both frames, three of which fix it.
std::optional<RigidTransform> AlignLandmarks(const IdentityOptions& identity,
                                             const ClusterAssociationOptions& association,
                                             const Cluster& cluster, Rng& rng) {
  std::vector<Descriptor> former;
  for (const Landmark& landmark : cluster.former.landmarks) former.push_back(landmark.descriptor);
  std::vector<StereoFeature> now;
  for (const Landmark& landmark : cluster.landmarks) {
    StereoFeature feature;
    feature.descriptor = landmark.descriptor;
    now.push_back(feature);
  }
  const std::vector<Match> matches =
      MatchDescriptors(former, now, association.rematch_hamming, association.rematch_ratio);
  Eigen::Matrix3Xd from(3, static_cast<Eigen::Index>(matches.size()));
  Eigen::Matrix3Xd to = from;
  for (std::size_t i = 0; i < matches.size(); ++i) {
    const Eigen::Index column = static_cast<Eigen::Index>(i);
    from.col(column) = cluster.landmarks[matches[i].feature].p_in_object;
    to.col(column) = cluster.former.landmarks[matches[i].landmark].p_in_object;
  }
  return AlignPointsRansac(from, to, identity.point_deviation * cluster.size_m,
                           association.min_rematch, association.ransac_iterations, rng);
}

// Where a body is in the frame that was predicted for it, by the centres of its boxes now and
// before it was lost, and by the prediction: each counts as far as it is certain.
Eigen::Vector3d ShiftFromPrediction(const RigidTransform& predicted_from_now,
                                    const CenterEstimate& now, const CenterEstimate& before,
                                    double variance_m2) {
  const Eigen::Vector3d measured = predicted_from_now * now.InObject() - before.InObject();
  if (now.boxes == 0 || before.boxes == 0) return measured;
  const Eigen::Matrix3d R = predicted_from_now.RotationMatrix();
  const Eigen::Matrix3d predicted = variance_m2 * Eigen::Matrix3d::Identity();
  const Eigen::Matrix3d boxes = R * now.Covariance() * R.transpose() + before.Covariance();
  return predicted * (predicted + boxes).llt().solve(measured);
}

void Inherit(const LostCluster& lost, const IdentityOptions& options, ClusterMap& map,
             Cluster& found) {
  const Cluster& before = FindCluster(map, lost.id);
  const RigidTransform now = found.Latest().world_from_object;
  const RigidTransform& predicted = lost.predicted.world_from_object;
  const double deviation = options.prediction_deviation;
  const double variance_m2 = deviation * deviation * lost.predicted.translation_variance_m2;
  const Eigen::Vector3d shift = ShiftFromPrediction(predicted.Inverse() * now, found.box_center,
                                                    before.box_center, variance_m2);
  const RigidTransform world_from_lost =
      predicted * RigidTransform(Eigen::Quaterniond::Identity(), shift);
  found.former = {FrameId{}, before.landmarks, before.box_center, shift, variance_m2};
  ClusterTrajectory later = std::move(map.trajectories[found.id]);
  map.trajectories.erase(found.id);
  ChangeFrame(now.Inverse() * world_from_lost, lost.id, found, later);
  found.id = lost.id;
  found.former.since =
      later.poses.empty() ? found.Latest().frame : FrameId{later.poses.front().frame};
  std::vector<ClusterPose>& poses = map.trajectories[lost.id].poses;
  // While both were live, the lost one was only predicted.
  std::erase_if(poses, [&](const ClusterPose& pose) {
    return !later.poses.empty() && pose.frame >= later.poses.front().frame;
  });
  poses.insert(poses.end(), later.poses.begin(), later.poses.end());
}

// The landmarks from before are in the cluster's frame again.
void MergeFormerLandmarks(Cluster& cluster) {
  for (Landmark& landmark : cluster.former.landmarks) {
    landmark.observations.clear();
    if (!landmark.past_information.isZero()) cluster.landmarks.push_back(landmark);
  }
  std::sort(cluster.landmarks.begin(), cluster.landmarks.end(),
            [](const Landmark& a, const Landmark& b) { return a.id < b.id; });
  cluster.box_center.Add(cluster.former.box_center);
  cluster.former = {};
}

void Remove(ClusterId id, FrameId newest, ClusterMap& map) {
  std::erase_if(map.archived, [&](const Cluster& cluster) { return cluster.id == id; });
  std::erase_if(map.live, [&](const Cluster& cluster) {
    return cluster.id == id && cluster.last_observed < newest;
  });
}

}  // namespace

std::vector<LostCluster> FindLostClusters(const ClusterOptions& options, FrameId newest,
                                          const ClusterPredictor& predict, const ClusterMap& map) {
  std::vector<LostCluster> lost;
  const auto add = [&](const Cluster& cluster) {
    if (cluster.last_observed == newest || !IsConfirmed(cluster, options)) return;
    lost.push_back({cluster.id, predict(cluster)});
  };
  for (const Cluster& cluster : map.live) add(cluster);
  for (const Cluster& cluster : map.archived) add(cluster);
  return lost;
}

void InheritIdentities(const std::vector<LostCluster>& lost, FrameId newest,
                       const IdentityOptions& identity, const ClusterOptions& options,
                       ClusterMap& map) {
  std::vector<ClusterId> inherited;
  for (Cluster& cluster : map.live) {
    if (!IsJustConfirmed(cluster, options, newest)) continue;
    const LostCluster* predecessor = FindPredecessor(cluster, lost, map, identity);
    if (!predecessor) continue;
    if (std::find(inherited.begin(), inherited.end(), predecessor->id) != inherited.end()) continue;
    inherited.push_back(predecessor->id);
    Inherit(*predecessor, identity, map, cluster);
  }
  for (const ClusterId id : inherited) Remove(id, newest, map);
  std::sort(map.live.begin(), map.live.end(),
            [](const Cluster& a, const Cluster& b) { return a.id < b.id; });
}

void AlignInheritedFrames(const IdentityOptions& identity,
                          const ClusterAssociationOptions& association, FrameId newest,
                          ClusterMap& map, Rng& rng) {
  for (Cluster& cluster : map.live) {
    Lineage& former = cluster.former;
    if (!former.since.valid()) continue;
    const std::int64_t age = newest.value - former.since.value;
    if (former.is_centered && age % identity.align_interval != 0) continue;
    ClusterTrajectory& trajectory = map.trajectories[cluster.id];
    if (const auto former_from_now = AlignLandmarks(identity, association, cluster, rng)) {
      ChangeFrame(former_from_now->Inverse(), cluster.id, cluster, trajectory);
      MergeFormerLandmarks(cluster);
    } else if (!former.is_centered && cluster.box_center.boxes >= identity.align_boxes) {
      const RigidTransform from_prediction(Eigen::Quaterniond::Identity(), former.shift_in_object);
      const Eigen::Vector3d shift = ShiftFromPrediction(
          from_prediction, cluster.box_center, former.box_center, former.prediction_variance_m2);
      const RigidTransform old_from_new(Eigen::Quaterniond::Identity(),
                                        Eigen::Vector3d(shift - former.shift_in_object));
      ChangeFrame(old_from_new, cluster.id, cluster, trajectory);
      former.is_centered = true;
    }
  }
}

void InheritLostIdentity::Update(const IdentityStep& step, ClusterMap& map, Rng&) {
  InheritIdentities(FindLostClusters(step.clusters, step.newest, step.predict, map), step.newest,
                    step.identity, step.clusters, map);
}

}  // namespace cvo
