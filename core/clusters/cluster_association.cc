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

// The body that the detection shows according to GivenKnowledge; invalid if unknown.
BodyId GivenBody(const FrameView& view, int detection) {
  const std::span<const BodyId> given = view.shown.detection_body;
  return given.empty() ? BodyId() : given[detection];
}

// Whether the detection may show the cluster, judged by its class and its given body.
bool MayShow(const FrameView& view, int detection, const Cluster& cluster) {
  const BodyId given = GivenBody(view, detection);
  return view.shown.detections[detection].category == cluster.category &&
         (!given.valid() || given == cluster.given_body);
}

// Looks for the cluster in the detection's box. If it is found, updates the track and returns true.
bool Reacquire(const ClusterSearch& search, const Cluster& cluster, int detection, Rng& rng,
               TakenFeatures& taken, ClusterTrack& track) {
  const Detection& seen = search.shown.detections[detection];
  if (!MayShow(search, detection, cluster)) return false;
  const std::vector<Match> matches = MatchInBox(search, cluster, {}, seen.box, taken);
  const auto solution = SolvePose(search, cluster, track.world_from_object, matches,
                                  search.options.association.min_rematch, false, rng);
  if (!solution || solution->inliers <= static_cast<int>(track.matches.size())) return false;
  AcceptPose(search, matches, *solution, taken, track);
  track.detection = detection;
  return true;
}

// Moves an archived cluster back to the live ones, which stay sorted by id, and inserts its track.
void Revive(std::size_t archived, const ClusterTrack& track, ClusterMap& map,
            std::vector<ClusterTrack>& tracks) {
  Cluster cluster = std::move(map.archived[archived]);
  map.archived.erase(map.archived.begin() + static_cast<std::ptrdiff_t>(archived));
  const auto place =
      std::lower_bound(map.live.begin(), map.live.end(), cluster.id,
                       [](const Cluster& live, ClusterId id) { return live.id < id; });
  tracks.insert(tracks.begin() + (place - map.live.begin()), track);
  map.live.insert(place, std::move(cluster));
}

// A cluster that was not found. Live ones are tried first, then archived ones, latest first.
struct Missing {
  bool is_live = true;
  std::size_t index = 0;  // into map.live or map.archived
};

std::vector<Missing> FindMissing(const ClusterMap& map, const std::vector<ClusterTrack>& tracks) {
  std::vector<Missing> missing;
  for (std::size_t q = 0; q < tracks.size(); ++q) {
    if (tracks[q].detection < 0 && !tracks[q].is_tracked) missing.push_back({true, q});
  }
  for (std::size_t k = map.archived.size(); k-- > 0;) missing.push_back({false, k});
  return missing;
}

// Matches detections that belong to no cluster with the landmarks of missing clusters.
class Reacquisition {
 public:
  Reacquisition(const ClusterSearch& search, const std::vector<PredictedCluster>& archived,
                ClusterMap& map, TakenFeatures& taken, std::vector<ClusterTrack>& tracks)
      : search_(search), archived_(archived), map_(map), taken_(taken), tracks_(tracks) {}

  void Try(int detection, Rng& rng) {
    for (const Missing& missing : FindMissing(map_, tracks_)) {
      ClusterTrack track = TrackOf(missing);
      if (!Reacquire(search_, ClusterOf(missing), detection, rng, taken_, track)) continue;
      Accept(missing, track);
      return;
    }
  }

 private:
  const Cluster& ClusterOf(const Missing& missing) const {
    return missing.is_live ? map_.live[missing.index] : map_.archived[missing.index];
  }

  ClusterTrack TrackOf(const Missing& missing) const {
    if (missing.is_live) return tracks_[missing.index];
    ClusterTrack track;
    track.predicted = archived_[missing.index];
    track.world_from_object = track.predicted.world_from_object;
    return track;
  }

  void Accept(const Missing& missing, const ClusterTrack& track) {
    if (missing.is_live) {
      tracks_[missing.index] = track;
      return;
    }
    archived_.erase(archived_.begin() + static_cast<std::ptrdiff_t>(missing.index));
    Revive(missing.index, track, map_, tracks_);
  }

  const ClusterSearch& search_;
  std::vector<PredictedCluster> archived_;
  ClusterMap& map_;
  TakenFeatures& taken_;
  std::vector<ClusterTrack>& tracks_;
};

// Releases the boxes of clusters that are only predicted.
void ReleaseUnseen(std::vector<ClusterTrack>& tracks) {
  for (ClusterTrack& track : tracks) {
    if (!track.is_tracked) track.detection = -1;
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

void RematchInBox::Reacquire(const ClusterSearch& search,
                             const std::vector<PredictedCluster>& archived, ClusterMap& map,
                             Rng& rng, TakenFeatures& taken, std::vector<ClusterTrack>& tracks) {
  ReleaseUnseen(tracks);
  std::vector<char> is_used(search.shown.detections.size(), 0);
  for (const ClusterTrack& track : tracks) {
    if (track.detection >= 0) is_used[track.detection] = 1;
  }
  Reacquisition reacquisition(search, archived, map, taken, tracks);
  for (int m = 0; m < static_cast<int>(is_used.size()); ++m) {
    if (!is_used[m]) reacquisition.Try(m, rng);
  }
}

void RematchInOwnBox::Reacquire(const ClusterSearch&, const std::vector<PredictedCluster>&,
                                ClusterMap&, Rng&, TakenFeatures&,
                                std::vector<ClusterTrack>& tracks) {
  for (ClusterTrack& track : tracks) {
    if (track.detection >= 0) track.is_tracked = true;
  }
}

void NoBoxRematch::Reacquire(const ClusterSearch&, const std::vector<PredictedCluster>&,
                             ClusterMap&, Rng&, TakenFeatures&,
                             std::vector<ClusterTrack>& tracks) {
  ReleaseUnseen(tracks);
}

}  // namespace cvo
