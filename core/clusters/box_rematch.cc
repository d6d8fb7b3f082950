// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/clusters/box_rematch.h"

#include <algorithm>

#include "core/association/descriptor_matching.h"
#include "core/clusters/cluster_pose.h"

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
    if (!IsAllowed(view, cluster, i)) continue;
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
  const ImageBox& box = view.shown.detections[track.detection].box;
  std::vector<Match> matches = MatchInBox(view, cluster, track.matches, box, taken);
  const int min_inliers =
      track.is_tracked ? view.options.clusters.min_tracked : view.options.association.min_rematch;
  matches.insert(matches.end(), track.matches.begin(), track.matches.end());
  std::sort(matches.begin(), matches.end(),
            [](const Match& a, const Match& b) { return a.landmark < b.landmark; });
  const auto solution = SolvePose(view, cluster, track.world_from_object, matches, min_inliers,
                                  track.is_tracked, rng);
  const int before = static_cast<int>(track.matches.size());
  if (solution && solution->inliers >= before) {
    AcceptPose(view, matches, *solution, taken, track);
  }
}

}  // namespace

void RematchInBox::Rematch(const FrameView& view, const ClusterMap& map, Rng& rng,
                           TakenFeatures& taken, std::vector<ClusterTrack>& tracks) {
  for (std::size_t q = 0; q < tracks.size(); ++q) {
    if (tracks[q].detection < 0) continue;
    RematchAssociated(view, map.live[q], rng, taken, tracks[q]);
  }
}

}  // namespace cvo
