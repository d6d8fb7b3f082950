// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/clusters/cluster_association.h"

#include <algorithm>
#include <cmath>

namespace cvo {

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

void PredictLandmarksOf(const FrameView& view, const Cluster& cluster, int q,
                        const PredictedCluster& at, std::vector<PredictedLandmark>& landmarks) {
  for (int i = 0; i < static_cast<int>(cluster.landmarks.size()); ++i) {
    const auto predicted = PredictLandmark(view, at, cluster.landmarks[i]);
    if (!predicted) continue;
    landmarks.push_back(*predicted);
    landmarks.back().cluster = q;
    landmarks.back().landmark = i;
  }
}

std::vector<Match> FindLandmarks(const FrameView& view, LandmarkSearch& find,
                                 std::span<const PredictedLandmark> landmarks,
                                 const TakenFeatures& taken) {
  const ClusterAssociationOptions& options = view.options.association;
  std::vector<Match> matches = find(landmarks, view.grid, taken, options);
  if (options.left_only) AddLeftOnlyMatches(landmarks, view.grid, taken, options, matches);
  return matches;
}

namespace {

// Whether the cluster's motion is known: two states give a velocity, the third checks it. Until
// then, the first matches may all be wrong: a pose is estimated by RANSAC instead of from the
// prediction.
bool IsSettled(const Cluster& cluster) { return cluster.states.size() >= 3; }

// Whether the pose shows the cluster. After a gap, a few of many matches agree by chance
// (METHOD.md 4.4).
bool IsFound(const FrameView& view, FrameId newest, const Cluster& cluster,
             const PredictedCluster& predicted, const CameraSolution& solution) {
  FrameId seen;
  for (const Landmark& landmark : cluster.landmarks) seen = std::max(seen, landmark.last_seen);
  const bool is_gap = newest.value - seen.value > 1;
  if (!is_gap) return true;
  const bool are_many = solution.inliers >= view.options.association.min_rematch;
  const bool is_expected =
      AgreesWithPrediction(predicted, view.world_from_camera * solution.world_from_camera.Inverse(),
                           view.options.noise.gate);
  return are_many + is_expected + solution.HalfAgrees() >= 2;
}

// Splits the matches by cluster, drops those that contradict given labels, estimates each
// provisional pose, keeps its inliers and marks their features as taken.
void TrackClusters(const FrameView& view, FrameId newest, const ClusterMap& map,
                   const std::vector<PredictedLandmark>& landmarks,
                   const std::vector<Match>& matches, Rng& rng, TakenFeatures& taken,
                   std::vector<ClusterTrack>& tracks) {
  std::vector<std::vector<Match>> by_cluster(tracks.size());
  for (const Match& match : matches) {
    const PredictedLandmark& from = landmarks[match.landmark];
    if (!IsAllowed(view, map.live[from.cluster], match.feature)) continue;
    by_cluster[from.cluster].push_back({from.landmark, match.feature, match.hamming});
  }
  for (std::size_t q = 0; q < tracks.size(); ++q) {
    const auto solution = SolvePose(view, map.live[q], tracks[q].world_from_object, by_cluster[q],
                                    view.options.clusters.min_tracked, IsSettled(map.live[q]), rng);
    if (solution && IsFound(view, newest, map.live[q], tracks[q].predicted, *solution)) {
      AcceptPose(view, by_cluster[q], *solution, taken, tracks[q]);
    }
  }
}

// Returns the matched landmarks of a tracked cluster; of any other cluster, those predicted to be
// visible.
std::vector<PredictedLandmark> MembersOf(const FrameView& view, const Cluster& cluster,
                                         const ClusterTrack& track) {
  std::vector<char> is_seen(cluster.landmarks.size(), !track.is_tracked);
  for (const Match& match : track.matches) is_seen[match.landmark] = 1;
  PredictedCluster at = track.predicted;
  at.world_from_object = track.world_from_object;
  std::vector<PredictedLandmark> members;
  for (std::size_t i = 0; i < cluster.landmarks.size(); ++i) {
    if (!is_seen[i]) continue;
    const auto predicted = PredictLandmark(view, at, cluster.landmarks[i]);
    if (predicted) members.push_back(*predicted);
  }
  return members;
}

// Assigns detections to the clusters (Eq. 3); given ones as they are given.
void ChooseBoxes(const FrameView& view, const AssociationSteps& steps, const ClusterMap& map,
                 std::vector<ClusterTrack>& tracks) {
  const std::span<const Detection> detections = view.shown.detections;
  const std::span<const BodyId> given = view.shown.detection_body;
  const int count = static_cast<int>(detections.size());
  std::vector<BoxProbabilities> probabilities;
  for (std::size_t q = 0; q < tracks.size(); ++q) {
    std::vector<ImageBox> boxes;  // one of another class contains nothing
    for (const Detection& detection : detections) {
      const bool may_be = !steps.compares_classes || detection.category == map.live[q].category;
      boxes.push_back(may_be ? detection.box : ImageBox{0.0, 0.0, -1.0, -1.0});
    }
    probabilities.push_back(steps.weigh(MembersOf(view, map.live[q], tracks[q]), boxes));
  }
  const std::vector<int> chosen =
      AssociateBoxes(probabilities, count, view.options.association, steps.box_cost);
  for (std::size_t q = 0; q < tracks.size(); ++q) {
    tracks[q].detection = given.empty() ? chosen[q] : -1;
    for (int m = 0; m < static_cast<int>(given.size()); ++m) {
      if (given[m].valid() && given[m] == map.live[q].given_body) tracks[q].detection = m;
    }
  }
}

// Sets the box of a track without a detection.
void FindBoxOfTrack(const FrameView& view, const Cluster& cluster, ClusterTrack& track) {
  if (track.detection >= 0) return;
  bool is_first = true;
  for (const PredictedLandmark& member : MembersOf(view, cluster, track)) {
    const double u = member.zeta_px[0];
    const double v = member.zeta_px[1];
    if (is_first) track.box = {u, v, u, v};
    is_first = false;
    Include(u, v, track.box);
  }
}

// Matches free features inside the box with landmarks of the cluster that are not in `matched`, by
// their descriptors.
std::vector<Match> MatchInBox(const FrameView& view, const Cluster& cluster,
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
  const std::span<const StereoFeature> features = view.frame.features;
  std::vector<Match> matches = MatchDescriptors(
      descriptors, features,
      [&](int i) {
        return !taken[i] && box.Contains(features[i].z_px[0], features[i].z_px[1]) &&
               IsAllowed(view, cluster, i);
      },
      kRematchHamming, kRematchRatio);
  for (Match& match : matches) match.landmark = landmarks[match.landmark];
  return matches;
}

// Maximum deviation of a predicted position at which a cluster is relaunched there, as a fraction
// of the body's size. With a half, more bodies keep their id, but more are placed wrongly.
constexpr double kRelaunchReach = 0.32;

// Adds matches inside the boxes of the clusters. They must agree with the cluster's pose or, if it
// has none, with each other.
void RematchAssociated(const FrameView& view, const ClusterMap& map, Rng& rng, TakenFeatures& taken,
                       std::vector<ClusterTrack>& tracks) {
  for (std::size_t q = 0; q < tracks.size(); ++q) {
    ClusterTrack& track = tracks[q];
    if (track.detection < 0) continue;
    const ImageBox& box = view.shown.detections[track.detection].box;
    std::vector<Match> matches = MatchInBox(view, map.live[q], track.matches, box, taken);
    const int min_inliers =
        track.is_tracked ? view.options.clusters.min_tracked : view.options.association.min_rematch;
    matches.insert(matches.end(), track.matches.begin(), track.matches.end());
    std::ranges::sort(matches, {}, &Match::landmark);
    const auto solution = SolvePose(view, map.live[q], track.world_from_object, matches,
                                    min_inliers, track.is_tracked, rng);
    if (solution && solution->inliers >= static_cast<int>(track.matches.size())) {
      AcceptPose(view, matches, *solution, taken, track);
    }
  }
}

}  // namespace

void RematchInBox::Rematch(const FrameView& view, const ClusterMap& map, Rng& rng,
                           TakenFeatures& taken, std::vector<ClusterTrack>& tracks) {
  RematchAssociated(view, map, rng, taken, tracks);
  for (std::size_t q = 0; q < tracks.size(); ++q) {
    const double deviation_m = std::sqrt(tracks[q].predicted.translation_variance_m2);
    const bool stays =
        !IsSettled(map.live[q]) || deviation_m < kRelaunchReach * Size_m(map.live[q]);
    tracks[q].is_tracked |= tracks[q].detection >= 0 && stays;
  }
  NoBoxRematch::Rematch(view, map, rng, taken, tracks);
}

void RematchAndRelaunch::Rematch(const FrameView& view, const ClusterMap& map, Rng& rng,
                                 TakenFeatures& taken, std::vector<ClusterTrack>& tracks) {
  RematchAssociated(view, map, rng, taken, tracks);
  for (ClusterTrack& track : tracks) track.is_tracked |= track.detection >= 0;
}

void NoBoxRematch::Rematch(const FrameView&, const ClusterMap&, Rng&, TakenFeatures&,
                           std::vector<ClusterTrack>& tracks) {
  for (ClusterTrack& track : tracks) {
    if (!track.is_tracked) track.detection = -1;
  }
}

std::vector<ClusterTrack> AssociateClusters(const FrameView& view, FrameId newest,
                                            const AssociationSteps& steps,
                                            const ClusterPredictor& predict, const ClusterMap& map,
                                            Rng& rng, TakenFeatures& taken) {
  std::vector<ClusterTrack> tracks(map.live.size());
  std::vector<PredictedLandmark> landmarks;
  for (std::size_t q = 0; q < tracks.size(); ++q) {
    tracks[q].predicted = predict(map.live[q]);
    tracks[q].world_from_object = tracks[q].predicted.world_from_object;
    PredictLandmarksOf(view, map.live[q], static_cast<int>(q), tracks[q].predicted, landmarks);
  }
  TrackClusters(view, newest, map, landmarks, FindLandmarks(view, *steps.find, landmarks, taken),
                rng, taken, tracks);
  ChooseBoxes(view, steps, map, tracks);
  steps.rematch(view, map, rng, taken, tracks);
  for (std::size_t q = 0; q < tracks.size(); ++q) FindBoxOfTrack(view, map.live[q], tracks[q]);
  return tracks;
}

}  // namespace cvo
