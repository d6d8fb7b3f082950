// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "core/association/descriptor_matching.h"
#include "core/odometry/cluster_association.h"

namespace cvo {
namespace {

// Free features inside the box whose descriptor is that of one of the cluster's unmatched
// landmarks.
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
  std::vector<StereoFeature> features;
  std::vector<int> indices;
  for (int i = 0; i < static_cast<int>(view.frame.features.size()); ++i) {
    const StereoFeature& feature = view.frame.features[i];
    if (taken[i] || !box.Contains(feature.z_px[0], feature.z_px[1])) continue;
    if (!internal::IsAllowed(view, cluster, i)) continue;
    features.push_back(feature);
    indices.push_back(i);
  }
  std::vector<Match> matches =
      MatchDescriptors(descriptors, features, view.options.association.rematch_hamming,
                       view.options.association.rematch_ratio);
  for (Match& match : matches) {
    match.landmark = landmarks[match.landmark];
    match.feature = indices[match.feature];
  }
  return matches;
}

// More correspondences inside the box of a cluster; they must agree with its pose, or with each
// other where it has none.
void RematchAssociated(const FrameView& view, const Cluster& cluster, Rng& rng,
                       TakenFeatures& taken, ClusterTrack& track) {
  const ImageBox& box = view.detections[track.detection].box;
  std::vector<Match> matches = MatchInBox(view, cluster, track.matches, box, taken);
  const int min_inliers =
      track.is_tracked ? view.options.clusters.min_tracked : view.options.association.min_rematch;
  matches.insert(matches.end(), track.matches.begin(), track.matches.end());
  std::sort(matches.begin(), matches.end(),
            [](const Match& a, const Match& b) { return a.landmark < b.landmark; });
  const auto solution = internal::SolvePose(view, cluster, track.world_from_object, matches,
                                            min_inliers, track.is_tracked, rng);
  const int before = static_cast<int>(track.matches.size());
  if (solution && solution->inliers >= before) {
    internal::AcceptPose(view, matches, *solution, taken, track);
  }
}

// Whether the cluster is what the detection shows; the track becomes that of the cluster there.
bool Reacquire(const FrameView& view, const Cluster& cluster, int detection, Rng& rng,
               TakenFeatures& taken, ClusterTrack& track) {
  const Detection& seen = view.detections[detection];
  if (cluster.category != seen.category) return false;
  const std::vector<Match> matches = MatchInBox(view, cluster, {}, seen.box, taken);
  const auto solution = internal::SolvePose(view, cluster, track.world_from_object, matches,
                                            view.options.association.min_rematch, false, rng);
  if (!solution || solution->inliers <= static_cast<int>(track.matches.size())) return false;
  internal::AcceptPose(view, matches, *solution, taken, track);
  track.detection = detection;
  return true;
}

// Puts an archived cluster back among the live ones, which stay sorted by id.
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

// A detection that belongs to no cluster is compared with those that are missing: live ones first,
// then archived ones, the latest first.
void ReacquireIn(const FrameView& view, int detection, ClusterMap& map, Rng& rng,
                 TakenFeatures& taken, std::vector<ClusterTrack>& tracks) {
  for (std::size_t q = 0; q < tracks.size(); ++q) {
    if (tracks[q].detection >= 0 || tracks[q].is_tracked) continue;
    if (Reacquire(view, map.live[q], detection, rng, taken, tracks[q])) return;
  }
  for (std::size_t k = map.archived.size(); k-- > 0;) {
    ClusterTrack track;
    track.predicted.world_from_object = map.archived[k].Latest().world_from_object;
    track.world_from_object = track.predicted.world_from_object;
    if (Reacquire(view, map.archived[k], detection, rng, taken, track)) {
      return Revive(k, track, map, tracks);
    }
  }
}

}  // namespace

void RematchInBox::Rematch(const FrameView& view, ClusterMap& map, Rng& rng, TakenFeatures& taken,
                           std::vector<ClusterTrack>& tracks) {
  std::vector<char> is_used(view.detections.size(), 0);
  for (std::size_t q = 0; q < tracks.size(); ++q) {
    if (tracks[q].detection < 0) continue;
    is_used[tracks[q].detection] = 1;
    RematchAssociated(view, map.live[q], rng, taken, tracks[q]);
  }
  if (!view.frame.given.detection_body.empty()) return;
  for (int m = 0; m < static_cast<int>(view.detections.size()); ++m) {
    if (!is_used[m]) ReacquireIn(view, m, map, rng, taken, tracks);
  }
}

}  // namespace cvo
