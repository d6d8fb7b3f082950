// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/clusters/identity.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <utility>

#include "core/association/matching.h"
#include "core/estimation/camera_solver.h"

namespace cvo {

namespace {

// Gate, in standard deviations, on how a lost cluster explains the position and the size of a new
// one: larger compares more pairs, and the landmarks decide (chosen from 1.5 ... 3 on the rooms,
// streets and the crowd, when it alone decided).
constexpr double kGate = 2.0;

// Standard deviation between the centres of one body estimated from its boxes before and after
// it was lost, as a fraction of its size (set by hand on the rendered rooms, not swept).
constexpr double kCenterDeviation = 0.3;

// Maximum standard deviation of a lost cluster's predicted position: bodies turn back, and
// rooms have walls (the free space of the rendered rooms, not swept).
constexpr double kMaxSpread_m = 1.0;

// Standard deviation of a body's size between boxes, as a factor: a turning body shows another
// side (set by hand on the rendered rooms, not swept).
constexpr double kSizeFactor = 1.7;

// Number of frames in which a new cluster is compared with lost ones: half a second at 30 Hz (not
// swept).
constexpr int kCompareFrames = 15;

// Maximum distance, as a fraction of the body's size, at which landmarks of the two clusters are
// taken for the same point (set by hand on the rendered rooms, not swept).
constexpr double kPointDeviation = 0.08;

bool AreGiven(const Cluster& found, const Cluster& lost) {
  return found.given_body.valid() && lost.given_body.valid();
}

// Whether two clusters may be the same body, judged by class and given body.
bool MayBeOne(const Cluster& found, const Cluster& lost) {
  return found.category == lost.category &&
         (!AreGiven(found, lost) || found.given_body == lost.given_body);
}

// Log ratio of two sizes; 0 if they may be equal, because the smaller one is of a part only, or if
// one is unknown: a body known from given labels alone has no size.
double LogRatio(const BodySize& a, const BodySize& b) {
  if (a.side_m == 0.0 || b.side_m == 0.0) return 0.0;
  const double ratio = std::log(a.side_m / b.side_m);
  const bool may_be_same = ratio < 0.0 ? !a.is_whole : !b.is_whole;
  return may_be_same ? 0.0 : ratio;
}

// How far the centre and size of the found cluster are from what the lost one leads to expect, in
// squared standard deviations.
double SquaredDistance(const Cluster& found, const Cluster& lost,
                       const PredictedCluster& predicted) {
  const double spread = std::min(std::sqrt(predicted.translation_variance_m2), kMaxSpread_m);
  const double deviation = std::hypot(spread, kCenterDeviation * lost.size.side_m);
  const Eigen::Vector3d offset = found.Latest().world_from_object * found.box_center.InObject() -
                                 predicted.world_from_object * lost.box_center.InObject();
  const double size = LogRatio(found.size, lost.size) / std::log(kSizeFactor);
  return offset.squaredNorm() / (deviation * deviation) + size * size;
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
  cluster.box_center = cluster.box_center.In(new_from_old);
}

// Estimates lost_from_found from landmarks with similar descriptors, which are points of both
// clusters; three of them determine it.
std::optional<RigidTransform> AlignLandmarks(const ClusterAssociationOptions& association,
                                             const Cluster& lost, const Cluster& found, Rng& rng) {
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
  return AlignPointsRansac(from, to, kPointDeviation * found.size.side_m, association.min_rematch,
                           kRansacIterations, rng);
}

// The lost cluster that a found one continues.
struct Predecessor {
  ClusterId id;
  RigidTransform lost_from_found;  // from the found cluster's frame to the lost one's
};

// Compares the found cluster with the lost ones that explain it, the most likely first.
std::optional<Predecessor> FindPredecessor(const IdentityStep& step, const Cluster& found,
                                           const std::vector<LostCluster>& lost,
                                           const ClusterMap& map, Rng& rng) {
  std::vector<std::pair<double, const Cluster*>> candidates;
  for (const LostCluster& candidate : lost) {
    const Cluster* cluster = FindCluster(map, candidate.id);
    if (cluster == nullptr || !MayBeOne(found, *cluster)) continue;
    const double distance =
        AreGiven(found, *cluster) ? 0.0 : SquaredDistance(found, *cluster, candidate.predicted);
    if (distance < kGate * kGate) candidates.emplace_back(distance, cluster);
  }
  std::sort(candidates.begin(), candidates.end(),
            [](const auto& a, const auto& b) { return a.first < b.first; });
  for (const auto& [distance, cluster] : candidates) {
    const auto lost_from_found = AlignLandmarks(step.association, *cluster, found, rng);
    if (lost_from_found) return Predecessor{cluster->id, *lost_from_found};
  }
  return std::nullopt;
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
  std::sort(found.landmarks.begin(), found.landmarks.end(),
            [](const Landmark& a, const Landmark& b) { return a.id < b.id; });
  found.box_center.Add(lost.box_center);
  std::vector<ClusterPose>& poses = map.trajectories[lost.id].poses;
  // While both clusters were live, the lost one was only predicted; drop those poses.
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

void InheritIdentities(const IdentityStep& step, const std::vector<LostCluster>& lost,
                       ClusterMap& map, Rng& rng) {
  std::vector<ClusterId> inherited;
  for (Cluster& cluster : map.live) {
    const bool is_new = cluster.frames <= kCompareFrames && cluster.last_observed == step.newest;
    if (!is_new || !IsConfirmed(cluster, step.clusters)) continue;
    const auto predecessor = FindPredecessor(step, cluster, lost, map, rng);
    if (!predecessor || std::ranges::count(inherited, predecessor->id) > 0) continue;
    inherited.push_back(predecessor->id);
    Inherit(*FindCluster(map, predecessor->id), predecessor->lost_from_found, map, cluster);
  }
  for (const ClusterId id : inherited) Remove(id, step.newest, map);
  std::sort(map.live.begin(), map.live.end(),
            [](const Cluster& a, const Cluster& b) { return a.id < b.id; });
}

void InheritLostIdentity::Update(const IdentityStep& step, ClusterMap& map, Rng& rng) {
  InheritIdentities(step, FindLostClusters(step.clusters, step.newest, step.predict, map), map,
                    rng);
}

}  // namespace cvo
