// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "core/association/box_association.h"
#include "core/association/matching.h"
#include "core/base/rng.h"
#include "core/clusters/cluster_prediction.h"
#include "core/estimation/cluster.h"
#include "core/geometry/rigid_transform.h"
#include "core/geometry/stereo_camera.h"

namespace cvo {

// Gives features found in the left image only, and matched with landmarks of a body, the disparity
// that the body's pose predicts for these landmarks (METHOD.md 4.7).
void PlaceLeftOnly(const StereoCamera& camera, const RigidTransform& camera_from_object,
                   const std::vector<Landmark>& landmarks, const std::vector<Match>& matches,
                   std::span<StereoFeature> features);

// How clusters are matched by descriptors alone, without a prediction, in the boxes that were
// assigned to them (paper, end of section 3.1), and what becomes of the boxes of clusters that were
// not found.
template <typename Policy>
concept BoxRematchPolicy = requires(const ClusterSearch& search, const ClusterMap& map, Rng& rng,
                                    TakenFeatures& taken, std::vector<ClusterTrack>& tracks) {
  Policy::Rematch(search, map, rng, taken, tracks);
  Policy::Conclude(tracks);
};

// Such a box may show another body: it is released.
struct ReleaseUnseen {
  static void Conclude(std::vector<ClusterTrack>& tracks);
};

// Policy: compares the descriptors in the box with those of the cluster's unmatched landmarks and
// keeps the matches that agree on a pose.
struct RematchInBox : ReleaseUnseen {
  static void Rematch(const ClusterSearch& search, const ClusterMap& map, Rng& rng,
                      TakenFeatures& taken, std::vector<ClusterTrack>& tracks);
};
// Policy: the same, but a cluster that was not found in its box keeps it and gets new landmarks
// there, at its predicted pose (the relaunch of the paper's section 4.2).
struct RematchAndRelaunch : RematchInBox {
  static void Conclude(std::vector<ClusterTrack>& tracks);
};
// Policy: no matching without a prediction.
struct NoBoxRematch : ReleaseUnseen {
  static void Rematch(const ClusterSearch&, const ClusterMap&, Rng&, TakenFeatures&,
                      std::vector<ClusterTrack>&) {}
};

namespace internal {

// Returns the matched landmarks of a tracked cluster; of any other cluster, those predicted to be
// visible.
std::vector<BoxMember> MembersOf(const ClusterSearch& search, const Cluster& cluster,
                                 const ClusterTrack& track);
// Landmarks of all clusters predicted to be visible, in one list, each with its cluster and index.
struct PredictedLandmarks {
  struct Source {
    int cluster = 0;   // index into map.live
    int landmark = 0;  // index in that cluster
  };
  std::vector<PredictedLandmark> predicted;
  std::vector<Source> source;
};
// Appends the landmarks of cluster q.
void PredictLandmarksOf(const ClusterSearch& search, const Cluster& cluster, int q,
                        const PredictedCluster& at, PredictedLandmarks& landmarks);
PredictedLandmarks PredictLandmarks(const ClusterSearch& search, const ClusterMap& map,
                                    const std::vector<ClusterTrack>& tracks);
// Returns matches whose `landmark` is an index into landmarks.predicted.
template <LandmarkAssociationPolicy LandmarkAssociation>
std::vector<Match> FindLandmarks(const ClusterSearch& search, const PredictedLandmarks& landmarks,
                                 const TakenFeatures& taken) {
  std::vector<Match> matches = LandmarkAssociation::Find(landmarks.predicted, search.grid, taken,
                                                         search.options.association);
  if (search.options.association.left_only) {
    AddLeftOnlyMatches(landmarks.predicted, search.grid, taken, search.options.association,
                       matches);
  }
  return matches;
}
// Splits the matches by cluster, drops those that contradict given labels, estimates each
// provisional pose, keeps its inliers and marks their features as taken.
void TrackClusters(const ClusterSearch& search, const ClusterMap& map,
                   const std::vector<PredictedLandmarks::Source>& source,
                   const std::vector<Match>& matches, Rng& rng, TakenFeatures& taken,
                   std::vector<ClusterTrack>& tracks);
void AssociateGivenDetections(const FrameView& view, const ClusterMap& map,
                              std::vector<ClusterTrack>& tracks);
// Removes boxes of other classes from the cluster's candidates.
void ForgetOtherCategories(const FrameView& view, const Cluster& cluster,
                           BoxProbabilities& probabilities);
std::vector<ImageBox> BoxesOf(std::span<const Detection> detections);
void FindBoxOfTrack(const ClusterSearch& search, const Cluster& cluster, ClusterTrack& track);

}  // namespace internal

// Whether a cluster may take a box of another class.
template <typename Policy>
concept ClassGatePolicy = requires(const FrameView& view, const Cluster& cluster,
                                   BoxProbabilities& probabilities) {
  Policy::Apply(view, cluster, probabilities);
};

// Policy: a cluster never takes a box of another class.
struct RefuseOtherClasses {
  static void Apply(const FrameView& view, const Cluster& cluster,
                    BoxProbabilities& probabilities) {
    internal::ForgetOtherCategories(view, cluster, probabilities);
  }
};
// Policy: a cluster may take a box of any class; the paper does not compare classes.
struct AcceptAnyClass {
  static void Apply(const FrameView&, const Cluster&, BoxProbabilities&) {}
};

// How boxes are assigned to clusters: weights of landmarks, costs, and classes.
template <typename Policy>
concept BoxPolicy = BoxWeightsPolicy<Policy> && BoxCostPolicy<Policy> && ClassGatePolicy<Policy>;

// Policy: ours (METHOD.md 4.5).
struct BoundedBoxes : BoundedBoxWeights, SharedBoxCost, RefuseOtherClasses {};
// Policy: the paper's.
struct PrintedBoxWeights : BoxWeightsLiteral, UnsharedBoxCost, AcceptAnyClass {};

// Multi-level association (section 3.1 of the paper): features with landmarks of the live clusters,
// then detections with clusters. Returns one track per cluster in map.live.
template <LandmarkAssociationPolicy LandmarkAssociation, BoxPolicy Boxes,
          BoxRematchPolicy BoxRematch>
std::vector<ClusterTrack> AssociateClusters(const ClusterSearch& search,
                                            const ClusterPredictor& predict, const ClusterMap& map,
                                            Rng& rng, TakenFeatures& taken) {
  std::vector<ClusterTrack> tracks(map.live.size());
  for (std::size_t q = 0; q < tracks.size(); ++q) {
    tracks[q].predicted = predict(map.live[q]);
    tracks[q].world_from_object = tracks[q].predicted.world_from_object;
  }
  const internal::PredictedLandmarks landmarks = internal::PredictLandmarks(search, map, tracks);
  const std::vector<Match> matches =
      internal::FindLandmarks<LandmarkAssociation>(search, landmarks, taken);
  internal::TrackClusters(search, map, landmarks.source, matches, rng, taken, tracks);

  const std::vector<ImageBox> boxes = internal::BoxesOf(search.shown.detections);
  std::vector<BoxProbabilities> probabilities;
  for (std::size_t q = 0; q < tracks.size(); ++q) {
    probabilities.push_back(
        Boxes::Compute(internal::MembersOf(search, map.live[q], tracks[q]), boxes));
    Boxes::Apply(search, map.live[q], probabilities.back());
  }
  const std::vector<int> chosen = AssociateBoxes(probabilities, static_cast<int>(boxes.size()),
                                                 search.options.association, &Boxes::Cost);
  for (std::size_t q = 0; q < tracks.size(); ++q) tracks[q].detection = chosen[q];
  internal::AssociateGivenDetections(search, map, tracks);
  BoxRematch::Rematch(search, map, rng, taken, tracks);
  BoxRematch::Conclude(tracks);
  for (std::size_t q = 0; q < tracks.size(); ++q) {
    internal::FindBoxOfTrack(search, map.live[q], tracks[q]);
  }
  return tracks;
}

}  // namespace cvo
