// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/clusters/cluster_map.h"

#include <Eigen/Cholesky>
#include <algorithm>

#include "core/base/lists.h"

namespace cvo {

namespace {

// Information from observations on a landmark's position x; its energy is
// 1/2 (x - mean)^T information (x - mean).
struct PointKnowledge {
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
  Eigen::Vector3d weighted_mean = Eigen::Vector3d::Zero();  // information * mean
};

// The information from one observation, linearised at the landmark's current position after the
// robust loss, with the pose of the body taken as exact.
PointKnowledge KnowledgeOf(const Window& window, const FeatureNoise& noise,
                           const RigidTransform& world_from_camera,
                           const RigidTransform& world_from_object, const Landmark& landmark,
                           const Observation& seen) {
  const RigidTransform camera_from_object = world_from_camera.Inverse() * world_from_object;
  const Eigen::Vector3d c = camera_from_object * landmark.p_in_object;
  const auto zeta_px = window.camera.Project(c);
  if (!zeta_px) return {};
  const Eigen::Matrix3d W = noise.SqrtInformation(seen);
  const Eigen::Matrix3d WJ =
      W * window.camera.ProjectionJacobian(c) * camera_from_object.RotationMatrix();
  const Eigen::Vector3d r = W * (seen.z_px - *zeta_px);
  const double weight = std::min(1.0, noise.options.huber / std::max(r.norm(), 1e-12));
  const Eigen::Matrix3d information = weight * WJ.transpose() * WJ;
  return {information, information * landmark.p_in_object + weight * WJ.transpose() * r};
}

// Scales the landmark's past information by `keep`, then adds the new information to it.
void AddKnowledge(const PointKnowledge& knowledge, double keep, Landmark& landmark) {
  const Eigen::Vector3d weighted =
      keep * landmark.past_information * landmark.past_mean_in_object + knowledge.weighted_mean;
  landmark.past_information = keep * landmark.past_information + knowledge.information;
  if (landmark.past_information.isZero()) return;
  // Invertible: the information along the line of sight is small for far points, but never zero.
  landmark.past_mean_in_object = landmark.past_information.ldlt().solve(weighted);
}

}  // namespace

void AbsorbObservations(const Window& window, const WindowFrame& leaving, const FeatureNoise& noise,
                        const ClusterOptions& options, Cluster& cluster) {
  const ClusterState* state = FindState(cluster, leaving.id);
  if (options.max_past_observations == 0.0 || !state) return;
  for (Landmark& landmark : cluster.landmarks) {
    const Observation* seen = FindObservation(landmark, leaving.id);
    if (!seen) continue;
    // A landmark observed in this frame alone has no estimated position to preserve.
    const bool is_estimated =
        landmark.observations.size() > 1 || !landmark.past_information.isZero();
    if (is_estimated) {
      const double keep = 1.0 - 1.0 / std::max(1.0, options.max_past_observations);
      AddKnowledge(KnowledgeOf(window, noise, leaving.world_from_camera, state->world_from_object,
                               landmark, *seen),
                   keep, landmark);
    }
    std::erase_if(landmark.observations,
                  [&](const Observation& o) { return o.frame == leaving.id; });
  }
}

void TrimCluster(const Window& window, FrameId newest, const ClusterOptions& options,
                 Cluster& cluster) {
  const FrameId oldest = window.temporal.front().id;
  // A hidden cluster is predicted from its last states, however old.
  const bool is_seen = cluster.last_observed == newest;
  while (is_seen && cluster.states.size() > 1 && cluster.states.front().frame < oldest) {
    cluster.states.erase(cluster.states.begin());
  }
  for (Landmark& landmark : cluster.landmarks) {
    std::erase_if(landmark.observations, [&](const Observation& o) { return o.frame < oldest; });
    // Most landmarks of a turning body are out of sight. Keeping the capacity for a window of
    // observations would double their memory.
    if (landmark.observations.empty()) landmark.observations.shrink_to_fit();
  }
  std::erase_if(cluster.landmarks, [](const Landmark& landmark) {
    return landmark.observations.empty() && landmark.past_information.isZero();
  });
  if (static_cast<int>(cluster.landmarks.size()) <= options.max_landmarks) return;
  std::vector<std::pair<FrameId, LandmarkId>> by_age;
  for (const Landmark& landmark : cluster.landmarks) {
    by_age.emplace_back(landmark.last_seen, landmark.id);
  }
  std::sort(by_age.rbegin(), by_age.rend());
  const auto oldest_kept = by_age[static_cast<std::size_t>(options.max_landmarks) - 1];
  std::erase_if(cluster.landmarks, [&](const Landmark& landmark) {
    return std::pair(landmark.last_seen, landmark.id) < oldest_kept && landmark.last_seen < newest;
  });
}

namespace {

// Motion of the outermost points of a body that stands still, as a fraction of its size (set by
// hand on the rendered rooms, not swept).
constexpr double kStandstill = 0.08;

// Whether neither boxes nor, during T_t, motion show it to be a body (METHOD.md 6.4).
bool LooksStatic(std::int64_t undetected, const ClusterOptions& options, const Cluster& cluster) {
  if (options.undetected_frames == 0 || cluster.given_body.valid()) return false;
  if (undetected < std::max(options.undetected_frames, cluster.detections)) return false;
  const RigidTransform moved =
      cluster.states.front().world_from_object.Inverse() * cluster.Latest().world_from_object;
  const double turned_m = RotationAngle(moved.rotation()) * cluster.half_size_m.maxCoeff();
  return moved.translation().norm() + turned_m < kStandstill * Size_m(cluster);
}

}  // namespace

void RetireClusters(FrameId newest, int live_frames, const ClusterOptions& options,
                    ClusterMap& map) {
  std::vector<Cluster> live;
  for (Cluster& cluster : map.live) {
    const std::int64_t unseen = newest.value - cluster.last_observed.value;
    const std::int64_t undetected = newest.value - cluster.last_detected.value;
    const bool is_confirmed = IsConfirmed(cluster, options);
    const bool is_gone = unseen >= live_frames || LooksStatic(undetected, options, cluster);
    if (!is_confirmed && (is_gone || undetected >= options.confirm_frames)) {
      map.trajectories.erase(cluster.id);
    } else if (!is_gone) {
      live.push_back(std::move(cluster));
    }
  }
  map.live = std::move(live);
}

std::vector<ClusterTrajectory> ConfirmedTrajectories(const ClusterMap& map,
                                                     const ClusterOptions& options) {
  std::vector<ClusterTrajectory> confirmed;
  for (const auto& [id, trajectory] : map.trajectories) {
    const auto live = std::find_if(map.live.begin(), map.live.end(),
                                   [id = id](const Cluster& cluster) { return cluster.id == id; });
    if (live != map.live.end() && !IsConfirmed(*live, options)) continue;
    confirmed.push_back(trajectory);
  }
  return confirmed;
}

void UpdateExtent(Cluster& cluster) {
  if (cluster.landmarks.empty()) return;
  Eigen::Matrix3Xd points(3, static_cast<Eigen::Index>(cluster.landmarks.size()));
  for (std::size_t i = 0; i < cluster.landmarks.size(); ++i) {
    points.col(static_cast<Eigen::Index>(i)) = cluster.landmarks[i].p_in_object;
  }
  const PointExtent extent = ExtentAlong(Eigen::Matrix3d::Identity(), points);
  cluster.center_in_object = extent.center;
  cluster.half_size_m = extent.half_size_m;
}

}  // namespace cvo
