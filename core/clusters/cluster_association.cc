// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/clusters/cluster_association.h"

#include <algorithm>

#include "core/association/matching.h"
#include "core/clusters/cluster_prediction.h"

namespace cvo {

// Number of states below which a pose is estimated by RANSAC instead of from the prediction:
// without a velocity, the first matches may all be wrong (two states give a velocity, the third
// checks it).
constexpr int kSettledStates = 3;

void PlaceLeftOnly(const StereoCamera& camera, const RigidTransform& camera_from_object,
                   const std::vector<Landmark>& landmarks, const std::vector<Match>& matches,
                   std::span<StereoFeature> features) {
  for (const Match& match : matches) {
    StereoFeature& feature = features[match.feature];
    if (!IsLeftOnly(feature)) continue;
    const auto zeta_px = camera.Project(camera_from_object * landmarks[match.landmark].p_in_object);
    if (zeta_px) feature.z_px[2] = feature.z_px[0] + (*zeta_px)[2] - (*zeta_px)[0];
  }
}

}  // namespace cvo

namespace cvo::internal {
void PredictLandmarksOf(const ClusterSearch& search, const Cluster& cluster, int q,
                        const PredictedCluster& at, PredictedLandmarks& landmarks) {
  for (int i = 0; i < static_cast<int>(cluster.landmarks.size()); ++i) {
    const auto predicted = PredictLandmark(search, at, cluster.landmarks[i]);
    if (!predicted) continue;
    landmarks.predicted.push_back(*predicted);
    landmarks.source.push_back({q, i});
  }
}

PredictedLandmarks PredictLandmarks(const ClusterSearch& search, const ClusterMap& map,
                                    const std::vector<ClusterTrack>& tracks) {
  PredictedLandmarks landmarks;
  for (int q = 0; q < static_cast<int>(map.live.size()); ++q) {
    PredictLandmarksOf(search, map.live[q], q, tracks[q].predicted, landmarks);
  }
  return landmarks;
}

void TrackClusters(const ClusterSearch& search, const ClusterMap& map,
                   const std::vector<PredictedLandmarks::Source>& source,
                   const std::vector<Match>& matches, Rng& rng, TakenFeatures& taken,
                   std::vector<ClusterTrack>& tracks) {
  std::vector<std::vector<Match>> by_cluster(tracks.size());
  for (const Match& match : matches) {
    const PredictedLandmarks::Source& from = source[match.landmark];
    if (!IsAllowed(search, map.live[from.cluster], match.feature)) continue;
    by_cluster[from.cluster].push_back({from.landmark, match.feature, match.hamming});
  }
  for (std::size_t q = 0; q < tracks.size(); ++q) {
    const bool is_settled = static_cast<int>(map.live[q].states.size()) >= kSettledStates;
    const auto solution = SolvePose(search, map.live[q], tracks[q].world_from_object, by_cluster[q],
                                    search.options.clusters.min_tracked, is_settled, rng);
    if (solution) AcceptPose(search, by_cluster[q], *solution, taken, tracks[q]);
  }
}

std::vector<BoxMember> MembersOf(const ClusterSearch& search, const Cluster& cluster,
                                 const ClusterTrack& track) {
  std::vector<char> is_seen(cluster.landmarks.size(), !track.is_tracked);
  for (const Match& match : track.matches) is_seen[match.landmark] = 1;
  PredictedCluster at = track.predicted;
  at.world_from_object = track.world_from_object;
  std::vector<BoxMember> members;
  for (std::size_t i = 0; i < cluster.landmarks.size(); ++i) {
    if (!is_seen[i]) continue;
    const auto predicted = PredictLandmark(search, at, cluster.landmarks[i]);
    if (!predicted) continue;
    members.push_back({predicted->zeta_px.head<2>(), predicted->measurement_px2.determinant(),
                       predicted->position_px2.determinant(),
                       predicted->innovation_px2.determinant()});
  }
  return members;
}

void ForgetOtherCategories(const FrameView& view, const Cluster& cluster,
                           BoxProbabilities& probabilities) {
  for (std::size_t m = 0; m < view.shown.detections.size(); ++m) {
    if (view.shown.detections[m].category != cluster.category) probabilities.probability[m] = 0.0;
  }
}

std::vector<ImageBox> BoxesOf(std::span<const Detection> detections) {
  std::vector<ImageBox> boxes;
  for (const Detection& detection : detections) boxes.push_back(detection.box);
  return boxes;
}

void AssociateGivenDetections(const FrameView& view, const ClusterMap& map,
                              std::vector<ClusterTrack>& tracks) {
  const std::span<const BodyId> given = view.shown.detection_body;
  if (given.empty()) return;
  for (std::size_t q = 0; q < tracks.size(); ++q) {
    tracks[q].detection = -1;
    for (int m = 0; m < static_cast<int>(given.size()); ++m) {
      if (given[m].valid() && given[m] == map.live[q].given_body) tracks[q].detection = m;
    }
  }
}

void FindBoxOfTrack(const ClusterSearch& search, const Cluster& cluster, ClusterTrack& track) {
  if (track.detection >= 0) return;  // represented by the detection's own box
  bool is_first = true;
  for (const BoxMember& member : MembersOf(search, cluster, track)) {
    const double u = member.zeta_px[0];
    const double v = member.zeta_px[1];
    if (is_first) track.box = {u, v, u, v};
    is_first = false;
    track.box = {std::min(track.box.left_px, u), std::min(track.box.top_px, v),
                 std::max(track.box.right_px, u), std::max(track.box.bottom_px, v)};
  }
}

}  // namespace cvo::internal

namespace cvo {

namespace {

// Matches free features inside the box with landmarks of the cluster that are not in `matched`, by
// their descriptors.
std::vector<Match> MatchInBox(const ClusterSearch& search, const Cluster& cluster,
                              const std::vector<Match>& matched, const ImageBox& box,
                              const TakenFeatures& taken) {
  std::vector<char> is_matched(cluster.landmarks.size(), 0);
  for (const Match& match : matched) is_matched[match.landmark] = 1;
  std::vector<Descriptor> descriptors;
  std::vector<int> landmarks;
  for (int i = 0; i < static_cast<int>(cluster.landmarks.size()); ++i) {
    if (is_matched[i]) continue;
    descriptors.push_back(cluster.landmarks[i].descriptor);
    landmarks.push_back(i);
  }
  std::vector<StereoFeature> features;
  std::vector<int> indices;
  for (int i = 0; i < static_cast<int>(search.frame.features.size()); ++i) {
    const StereoFeature& feature = search.frame.features[i];
    if (taken[i] || !box.Contains(feature.z_px[0], feature.z_px[1])) continue;
    if (!IsAllowed(search, cluster, i)) continue;
    features.push_back(feature);
    indices.push_back(i);
  }
  std::vector<Match> matches =
      MatchDescriptors(descriptors, features, kRematchHamming, kRematchRatio);
  for (Match& match : matches) {
    match.landmark = landmarks[match.landmark];
    match.feature = indices[match.feature];
  }
  return matches;
}

// Adds matches inside the cluster's box. They must agree with its pose or, if it has none, with
// each other.
void RematchAssociated(const ClusterSearch& search, const Cluster& cluster, Rng& rng,
                       TakenFeatures& taken, ClusterTrack& track) {
  const ImageBox& box = search.shown.detections[track.detection].box;
  std::vector<Match> matches = MatchInBox(search, cluster, track.matches, box, taken);
  const int min_inliers = track.is_tracked ? search.options.clusters.min_tracked
                                           : search.options.association.min_rematch;
  matches.insert(matches.end(), track.matches.begin(), track.matches.end());
  std::sort(matches.begin(), matches.end(),
            [](const Match& a, const Match& b) { return a.landmark < b.landmark; });
  const auto solution = SolvePose(search, cluster, track.world_from_object, matches, min_inliers,
                                  track.is_tracked, rng);
  const int before = static_cast<int>(track.matches.size());
  if (solution && solution->inliers >= before) {
    AcceptPose(search, matches, *solution, taken, track);
  }
}

}  // namespace

void RematchInBox::Rematch(const ClusterSearch& search, const ClusterMap& map, Rng& rng,
                           TakenFeatures& taken, std::vector<ClusterTrack>& tracks) {
  for (std::size_t q = 0; q < tracks.size(); ++q) {
    if (tracks[q].detection < 0) continue;
    RematchAssociated(search, map.live[q], rng, taken, tracks[q]);
  }
}

void ReleaseUnseen::Conclude(std::vector<ClusterTrack>& tracks) {
  for (ClusterTrack& track : tracks) {
    if (!track.is_tracked) track.detection = -1;
  }
}

void RematchAndRelaunch::Conclude(std::vector<ClusterTrack>& tracks) {
  for (ClusterTrack& track : tracks) {
    if (track.detection >= 0) track.is_tracked = true;
  }
}

}  // namespace cvo
