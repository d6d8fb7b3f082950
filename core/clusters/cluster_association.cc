// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/clusters/cluster_association.h"

#include <algorithm>
#include <cmath>

#include "core/clusters/point_measurements.h"
#include "core/estimation/camera_ransac.h"

namespace cvo::internal {
namespace {

// A cluster with fewer states has no velocity yet: its first matches may all be wrong.
constexpr std::size_t kSettledStates = 3;

}  // namespace

bool IsAllowed(const FrameView& view, const Cluster& cluster, int feature) {
  const std::vector<int>& given = view.given.feature_body;
  return given.empty() || given[feature] < 0 || given[feature] == cluster.given_body;
}

PredictedLandmarks PredictLandmarks(const FrameView& view, const ClusterMap& map,
                                    const std::vector<ClusterTrack>& tracks) {
  PredictedLandmarks result;
  for (int q = 0; q < static_cast<int>(map.live.size()); ++q) {
    const Cluster& cluster = map.live[q];
    for (int i = 0; i < static_cast<int>(cluster.landmarks.size()); ++i) {
      const auto predicted = PredictLandmark(view.options, view.camera, view.world_from_camera,
                                             tracks[q].predicted, cluster.landmarks[i]);
      if (!predicted) continue;
      result.predicted.push_back(*predicted);
      result.source.push_back({i, q, 0});
    }
  }
  return result;
}

std::optional<CameraSolution> SolvePose(const FrameView& view, const Cluster& cluster,
                                        const RigidTransform& world_from_object,
                                        const std::vector<Match>& matches, int min_inliers,
                                        bool is_predicted, Rng& rng) {
  if (static_cast<int>(matches.size()) < min_inliers) return std::nullopt;
  const std::vector<PointMeasurement> measurements =
      MeasurementsOf(view.options, cluster.landmarks, view.frame.features, matches);
  if (is_predicted) {
    const RigidTransform object_from_camera = world_from_object.Inverse() * view.world_from_camera;
    CameraSolution solution =
        SolveCamera(view.camera, measurements, object_from_camera, view.options.noise);
    if (solution.inliers >= min_inliers && 2 * solution.inliers >= static_cast<int>(matches.size()))
      return solution;
  }
  return SolveCameraRansac(view.camera, measurements, view.options.noise,
                           view.options.association.ransac_iterations, min_inliers, rng);
}

void AcceptPose(const FrameView& view, const std::vector<Match>& matches,
                const CameraSolution& solution, TakenFeatures& taken, ClusterTrack& track) {
  track.world_from_object = view.world_from_camera * solution.world_from_camera.Inverse();
  track.is_tracked = true;
  track.matches.clear();
  for (std::size_t i = 0; i < matches.size(); ++i) {
    if (!solution.is_inlier[i]) continue;
    track.matches.push_back(matches[i]);
    taken[matches[i].feature] = 1;
  }
}

void TrackClusters(const FrameView& view, const ClusterMap& map, const std::vector<Match>& source,
                   const std::vector<Match>& matches, Rng& rng, TakenFeatures& taken,
                   std::vector<ClusterTrack>& tracks) {
  std::vector<std::vector<Match>> by_cluster(tracks.size());
  for (const Match& match : matches) {
    const Match& from = source[match.landmark];
    if (!IsAllowed(view, map.live[from.feature], match.feature)) continue;
    by_cluster[from.feature].push_back({from.landmark, match.feature, match.hamming});
  }
  for (std::size_t q = 0; q < tracks.size(); ++q) {
    const bool is_settled = map.live[q].states.size() >= kSettledStates;
    const auto solution = SolvePose(view, map.live[q], tracks[q].world_from_object, by_cluster[q],
                                    view.options.clusters.min_tracked, is_settled, rng);
    if (solution) AcceptPose(view, by_cluster[q], *solution, taken, tracks[q]);
  }
}

std::vector<BoxMember> MembersOf(const FrameView& view, const Cluster& cluster,
                                 const ClusterTrack& track) {
  std::vector<char> is_seen(cluster.landmarks.size(), !track.is_tracked);
  for (const Match& match : track.matches) is_seen[match.landmark] = 1;
  PredictedCluster at = track.predicted;
  at.world_from_object = track.world_from_object;
  std::vector<BoxMember> members;
  for (std::size_t i = 0; i < cluster.landmarks.size(); ++i) {
    if (!is_seen[i]) continue;
    const auto predicted = PredictLandmark(view.options, view.camera, view.world_from_camera, at,
                                           cluster.landmarks[i]);
    if (!predicted) continue;
    members.push_back({predicted->zeta_px.head<2>(), predicted->measurement_px2.determinant(),
                       predicted->position_px2.determinant(),
                       predicted->innovation_px2.determinant()});
  }
  return members;
}

void ForgetOtherCategories(const FrameView& view, const Cluster& cluster,
                           BoxProbabilities& probabilities) {
  for (std::size_t m = 0; m < view.detections.size(); ++m) {
    if (view.detections[m].category != cluster.category) probabilities.members[m] = 0;
  }
}

std::vector<ImageBox> BoxesOf(const std::vector<Detection>& detections) {
  std::vector<ImageBox> boxes;
  for (const Detection& detection : detections) boxes.push_back(detection.box);
  return boxes;
}

void AssociateGivenDetections(const FrameView& view, const ClusterMap& map,
                              std::vector<ClusterTrack>& tracks) {
  const std::vector<int>& given = view.given.detection_body;
  if (given.empty()) return;
  for (std::size_t q = 0; q < tracks.size(); ++q) {
    tracks[q].detection = -1;
    for (int m = 0; m < static_cast<int>(given.size()); ++m) {
      if (given[m] >= 0 && given[m] == map.live[q].given_body) tracks[q].detection = m;
    }
  }
}

void FindBoxOfTrack(const FrameView& view, const Cluster& cluster, ClusterTrack& track) {
  if (track.detection >= 0) return;  // the detection's own box stands for it
  bool is_first = true;
  for (const BoxMember& member : MembersOf(view, cluster, track)) {
    const double u = member.zeta_px[0];
    const double v = member.zeta_px[1];
    if (is_first) track.box = {u, v, u, v};
    is_first = false;
    track.box = {std::min(track.box.left_px, u), std::min(track.box.top_px, v),
                 std::max(track.box.right_px, u), std::max(track.box.bottom_px, v)};
  }
}

}  // namespace cvo::internal
