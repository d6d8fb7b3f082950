// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/clusters/identity.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "core/association/matching.h"
#include "core/estimation/camera_solver.h"

namespace cvo {

namespace {

// Gate, in standard deviations, for a new cluster to inherit the id of a lost cluster of its
// class; the lost cluster must explain its position and size at least as well as one predicted
// to within kMaxSpread_m does at this many standard deviations; larger keeps more
// identities and confuses more (chosen from 1.5 ... 3 on the rooms, streets and the crowd).
constexpr double kGate = 2.0;

// Standard deviation between the centres of one body estimated from its boxes before and after
// it was lost (set by hand on the rendered rooms, not swept).
constexpr double kCenterDeviation = 0.3;

// Maximum standard deviation of a lost cluster's predicted position: bodies turn back, and
// rooms have walls (the free space of the rendered rooms, not swept).
constexpr double kMaxSpread_m = 1.0;

// Standard deviation of a re-found cluster's position about the position that its motion before
// and after the loss predicts; larger trusts the boxes, smaller the motion (chosen from 0.3,
// 0.6 and 1 on development rooms, crowds, benches and streets, where little but the object ATE
// of benches changes).
constexpr double kPredictionDeviation = 0.3;

// Minimum log-likelihood margin over the second-best candidate; with larger values, doubtful
// clusters keep a new id (set by hand on the rooms and the crowd, not swept).
constexpr double kMinLead = 0.25;

// Standard deviation of a body's size between boxes, as a factor: a turning body shows another
// side (set by hand on the rendered rooms, not swept).
constexpr double kSizeFactor = 1.7;

// Number of boxes up to which a re-found cluster's frame is re-estimated in every frame, unless
// landmarks aligned it earlier (half a second at 30 Hz, not swept).
constexpr int kAlignBoxes = 15;

// Frames between searches for landmarks to refine a frame that was aligned by centres (bounds
// time).
constexpr int kAlignInterval = 5;

// Maximum distance at which landmarks of the old and the new object frame are taken for the
// same point (set by hand on the rendered rooms, not swept).
constexpr double kPointDeviation = 0.08;

const Cluster& LostOne(const ClusterMap& map, ClusterId id) {
  const Cluster* cluster = FindCluster(map, id);
  Require(cluster != nullptr, "InheritIdentities: a lost cluster is neither live nor archived");
  return *cluster;
}

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

// How poorly a lost cluster explains the centre and size of the found one: the negative logarithm
// of the probability density (1/m^3), up to a constant. A cluster that may be anywhere explains
// every place poorly.
double ExplanationEnergy(const Cluster& found, const Cluster& lost,
                         const PredictedCluster& predicted) {
  const double spread = std::min(std::sqrt(predicted.translation_variance_m2), kMaxSpread_m);
  const double deviation = std::hypot(spread, kCenterDeviation * lost.size.side_m);
  const Eigen::Vector3d offset = found.Latest().world_from_object * found.box_center.InObject() -
                                 predicted.world_from_object * lost.box_center.InObject();
  const double size = LogRatio(found.size, lost.size) / std::log(kSizeFactor);
  return 0.5 * (offset.squaredNorm() / (deviation * deviation) + size * size) +
         3.0 * std::log(deviation);
}

// Returns the lost cluster that the found one continues; null if there is none or the choice is
// ambiguous.
const LostCluster* FindPredecessor(const Cluster& found, const std::vector<LostCluster>& lost,
                                   const ClusterMap& map) {
  const LostCluster* best = nullptr;
  double least = 0.5 * kGate * kGate;
  double second = std::numeric_limits<double>::infinity();
  for (const LostCluster& candidate : lost) {
    const Cluster& cluster = LostOne(map, candidate.id);
    if (!MayBeOne(found, cluster)) continue;
    if (AreGiven(found, cluster)) return &candidate;
    const double energy = ExplanationEnergy(found, cluster, candidate.predicted);
    if (energy < least) {
      if (best) second = least;
      least = energy;
      best = &candidate;
    } else {
      second = std::min(second, energy);
    }
  }
  return second - least > kMinLead ? best : nullptr;
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

// Expresses a cluster and its landmarks in another frame of the same body, and gives its poses and
// landmarks the id `id`.
void ChangeFrame(const RigidTransform& old_from_new, ClusterId id, Cluster& cluster,
                 ClusterTrajectory& trajectory) {
  const RigidTransform new_from_old = old_from_new.Inverse();
  const Eigen::Matrix3d R = new_from_old.RotationMatrix();
  ChangeFrameOfPoses(old_from_new, std::span(cluster.states));
  // Poses from before the loss are not affected.
  const auto first = FirstPoseFrom(cluster.former.since.value, trajectory);
  ChangeFrameOfPoses(old_from_new, std::span(first, trajectory.poses.end()));
  std::for_each(first, trajectory.poses.end(), [&](ClusterPose& pose) {
    pose.id = id;
    pose.center_in_object = new_from_old * pose.center_in_object;
    pose.box.object_from_box = new_from_old * pose.box.object_from_box;
  });
  for (Landmark& landmark : cluster.landmarks) {
    landmark.label.cluster = id;
    landmark.p_in_object = new_from_old * landmark.p_in_object;
    landmark.covariance.in_object_m2 = R * landmark.covariance.in_object_m2 * R.transpose();
    landmark.past_information = R * landmark.past_information * R.transpose();
    landmark.past_mean_in_object = new_from_old * landmark.past_mean_in_object;
  }
  cluster.center_in_object = new_from_old * cluster.center_in_object;
  cluster.box_center = cluster.box_center.In(new_from_old);
}

// Estimates former_from_now from landmarks with similar descriptors, which are points in both
// frames; three of them determine it.
std::optional<RigidTransform> AlignLandmarks(const ClusterAssociationOptions& association,
                                             const Cluster& cluster, Rng& rng) {
  std::vector<Descriptor> former;
  for (const Landmark& landmark : cluster.former.landmarks) former.push_back(landmark.descriptor);
  std::vector<StereoFeature> now;
  for (const Landmark& landmark : cluster.landmarks) {
    StereoFeature feature;
    feature.descriptor = landmark.descriptor;
    now.push_back(feature);
  }
  const std::vector<Match> matches = MatchDescriptors(former, now, kRematchHamming, kRematchRatio);
  Eigen::Matrix3Xd from(3, static_cast<Eigen::Index>(matches.size()));
  Eigen::Matrix3Xd to = from;
  for (std::size_t i = 0; i < matches.size(); ++i) {
    const Eigen::Index column = static_cast<Eigen::Index>(i);
    from.col(column) = cluster.landmarks[matches[i].feature].p_in_object;
    to.col(column) = cluster.former.landmarks[matches[i].landmark].p_in_object;
  }
  return AlignPointsRansac(from, to, kPointDeviation * cluster.size.side_m, association.min_rematch,
                           kRansacIterations, rng);
}

BodyMotion MotionAtLoss(const Cluster& cluster) {
  const ClusterState& last = cluster.Latest();
  return {last.timestamp_ns,
          last.world_from_object,
          last.velocity_m_s,
          TurnRate(std::span<const ClusterState>(cluster.states), cluster.states.size() - 1),
          SpeedVariance(cluster),
          TurnVariance(cluster)};
}

// Motion at the first of a found cluster's poses that is after its loss at lost_ns, or at the last
// pose if none is. Needs at least one pose.
template <typename Pose>
BodyMotion MotionWhenFound(const Cluster& cluster, std::span<const Pose> poses,
                           std::int64_t lost_ns) {
  const auto is_before = [lost_ns](const Pose& pose) { return pose.timestamp_ns <= lost_ns; };
  const auto first = std::find_if_not(poses.begin(), poses.end() - 1, is_before);
  return {first->timestamp_ns,    first->world_from_object,
          first->velocity_m_s,    TurnRate(std::span<const Pose>(first, poses.end()), 0),
          SpeedVariance(cluster), TurnVariance(cluster)};
}

// The former frame of a body at the time when the body was found, as estimated from its motions
// before and after the gap.
struct BridgedPose {
  RigidTransform world_from_object;
  double variance_m2 = 0.0;  // of its origin, per axis
};

BridgedPose BridgeGap(const BodyMotion& before, const BodyMotion& found,
                      const MotionPriorOptions& motion) {
  const double dt = SecondsBetween(before.timestamp_ns, found.timestamp_ns);
  const double turn_density =
      TurnDensity(motion, std::max(before.turn_rad_s.norm(), found.turn_rad_s.norm()));
  const BridgedMotion turn =
      BridgeMotion(dt, turn_density, before.turn_variance_rad2_s2, found.turn_variance_rad2_s2);
  const BridgedMotion way =
      BridgeMotion(dt, motion.q_m2_s3, before.speed_variance_m2_s2, found.speed_variance_m2_s2);
  const Eigen::Vector3d rate =
      before.turn_rad_s + turn.later_share * (found.turn_rad_s - before.turn_rad_s);
  // The origin x moves with the found body, at the velocity v(x) = v + w x (x - t). This is linear
  // in x, which therefore solves A x = b.
  const double share_s = way.later_share * dt;
  const Eigen::Vector3d t = found.world_from_object.translation();
  const Eigen::Matrix3d A = Eigen::Matrix3d::Identity() - share_s * Skew(found.turn_rad_s);
  const Eigen::Vector3d b =
      before.world_from_object.translation() + dt * before.velocity_m_s +
      share_s * (found.velocity_m_s - found.turn_rad_s.cross(t) - before.velocity_m_s);
  return {RigidTransform(ExpSo3(rate * dt) * before.world_from_object.rotation(),
                         Eigen::Vector3d(A.inverse() * b)),
          way.variance};
}

// Estimates world_from_former of a found body from its motions before and after the gap and from
// the centres that its boxes show, each weighted by its certainty.
RigidTransform PlaceFormer(const IdentityStep& step, const Lineage& former, const BodyMotion& found,
                           const CenterEstimate& now) {
  const BridgedPose bridged = BridgeGap(former.last, found, step.motion);
  const RigidTransform bridged_from_now =
      bridged.world_from_object.Inverse() * found.world_from_object;
  Eigen::Vector3d shift = bridged_from_now * now.InObject() - former.box_center.InObject();
  if (now.boxes > 0 && former.box_center.boxes > 0) {
    const double deviation = kPredictionDeviation;
    const Eigen::Matrix3d R = bridged_from_now.RotationMatrix();
    const Eigen::Matrix3d by_motion =
        deviation * deviation * bridged.variance_m2 * Eigen::Matrix3d::Identity();
    const Eigen::Matrix3d by_boxes =
        R * now.Covariance() * R.transpose() + former.box_center.Covariance();
    shift = by_motion * (by_motion + by_boxes).llt().solve(shift);
  }
  return bridged.world_from_object * RigidTransform(Eigen::Quaterniond::Identity(), shift);
}

void Inherit(const IdentityStep& step, ClusterId lost, ClusterMap& map, Cluster& found) {
  const Cluster& before = LostOne(map, lost);
  found.former = {FrameId{}, before.landmarks, before.box_center, MotionAtLoss(before)};
  const BodyMotion motion =
      MotionWhenFound<ClusterState>(found, found.states, found.former.last.timestamp_ns);
  const RigidTransform world_from_lost = PlaceFormer(step, found.former, motion, found.box_center);
  ClusterTrajectory later = std::move(map.trajectories[found.id]);
  map.trajectories.erase(found.id);
  ChangeFrame(motion.world_from_object.Inverse() * world_from_lost, lost, found, later);
  found.id = lost;
  found.former.since =
      later.poses.empty() ? found.Latest().frame : FrameId{later.poses.front().frame};
  std::vector<ClusterPose>& poses = map.trajectories[lost].poses;
  // While both clusters were live, the lost one was only predicted; drop those poses.
  std::erase_if(poses, [&](const ClusterPose& pose) {
    return !later.poses.empty() && pose.frame >= later.poses.front().frame;
  });
  poses.insert(poses.end(), later.poses.begin(), later.poses.end());
}

// Gives the former landmarks that have past information back to the cluster, whose frame is the
// former one again.
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

void InheritIdentities(const IdentityStep& step, const std::vector<LostCluster>& lost,
                       ClusterMap& map) {
  std::vector<ClusterId> inherited;
  for (Cluster& cluster : map.live) {
    if (!IsJustConfirmed(cluster, step.clusters, step.newest)) continue;
    const LostCluster* predecessor = FindPredecessor(cluster, lost, map);
    if (!predecessor) continue;
    if (std::find(inherited.begin(), inherited.end(), predecessor->id) != inherited.end()) continue;
    inherited.push_back(predecessor->id);
    Inherit(step, predecessor->id, map, cluster);
  }
  for (const ClusterId id : inherited) Remove(id, step.newest, map);
  std::sort(map.live.begin(), map.live.end(),
            [](const Cluster& a, const Cluster& b) { return a.id < b.id; });
}

void AlignInheritedFrames(const IdentityStep& step, ClusterMap& map, Rng& rng) {
  for (Cluster& cluster : map.live) {
    Lineage& former = cluster.former;
    if (!former.since.valid()) continue;
    const std::int64_t age = step.newest.value - former.since.value;
    if (former.is_placed && age % kAlignInterval != 0) continue;
    ClusterTrajectory& trajectory = map.trajectories[cluster.id];
    if (const auto former_from_now = AlignLandmarks(step.association, cluster, rng)) {
      ChangeFrame(former_from_now->Inverse(), cluster.id, cluster, trajectory);
      MergeFormerLandmarks(cluster);
    } else if (!former.is_placed) {
      const std::span<const ClusterPose> since(FirstPoseFrom(former.since.value, trajectory),
                                               trajectory.poses.end());
      if (since.empty() || since.back().timestamp_ns <= former.last.timestamp_ns) continue;
      const BodyMotion motion = MotionWhenFound(cluster, since, former.last.timestamp_ns);
      ChangeFrame(motion.world_from_object.Inverse() *
                      PlaceFormer(step, former, motion, cluster.box_center),
                  cluster.id, cluster, trajectory);
      former.is_placed = cluster.box_center.boxes >= kAlignBoxes;
    }
  }
}

void InheritLostIdentity::Update(const IdentityStep& step, ClusterMap& map, Rng& rng) {
  InheritIdentities(step, FindLostClusters(step.clusters, step.newest, step.predict, map), map);
  AlignInheritedFrames(step, map, rng);
}

}  // namespace cvo
