// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/association/box_association.h"
#include "core/association/feature_grid.h"
#include "core/association/gated_matching.h"
#include "core/base/rng.h"
#include "core/clusters/cluster_map.h"
#include "core/clusters/cluster_prediction.h"
#include "core/estimation/camera_solver.h"
#include "core/interface/frame.h"

namespace cvo {

// What association finds out about one live cluster in the current frame.
struct ClusterTrack {
  PredictedCluster predicted;
  RigidTransform world_from_object;  // provisional P_t^q if is_tracked, else predicted
  bool is_tracked = false;           // at least min_tracked consistent landmarks
  std::vector<Match> matches;        // consistent ones: index into cluster.landmarks, feature
  int detection = -1;                // index into the frame's detections; -1: none
  ImageBox box;                      // around its landmarks, matched or predicted
};

// The current frame, as far as it is known when clusters are associated.
struct FrameView {
  const Options& options;
  const StereoFrame& frame;
  const std::vector<Detection>& detections;  // what the variant is shown
  const GivenKnowledge& given;               // of bodies: what the variant is shown
  const FeatureGrid& grid;
  StereoCamera camera;
  RigidTransform world_from_camera;
};

// Features that are matched already, by index.
using TakenFeatures = std::vector<char>;

namespace internal {

// Landmarks that were found; where the cluster was not found, those that should be seen.
std::vector<BoxMember> MembersOf(const FrameView& view, const Cluster& cluster,
                                 const ClusterTrack& track);
// Landmarks of all clusters that should be seen, flattened, with where they came from.
struct PredictedLandmarks {
  std::vector<PredictedLandmark> predicted;
  std::vector<Match> source;  // `landmark`: index in its cluster, `feature`: index of the cluster
};
PredictedLandmarks PredictLandmarks(const FrameView& view, const ClusterMap& map,
                                    const std::vector<ClusterTrack>& tracks);
// Splits matches by cluster, drops those that given labels forbid, solves each provisional pose and
// keeps what agrees with it; marks the features taken.
void TrackClusters(const FrameView& view, const ClusterMap& map, const std::vector<Match>& source,
                   const std::vector<Match>& matches, Rng& rng, TakenFeatures& taken,
                   std::vector<ClusterTrack>& tracks);
// What the cluster and the feature are given to be does not forbid that one belongs to the other.
bool IsAllowed(const FrameView& view, const Cluster& cluster, int feature);
// object_from_camera from matches, as a CameraSolution whose world is the object: from the
// predicted pose where it can be trusted (is_predicted) and explains most of them, else by RANSAC.
// Empty where fewer than min_inliers agree.
std::optional<CameraSolution> SolvePose(const FrameView& view, const Cluster& cluster,
                                        const RigidTransform& world_from_object,
                                        const std::vector<Match>& matches, int min_inliers,
                                        bool is_predicted, Rng& rng);
// The track takes the solution's pose and inliers.
void AcceptPose(const FrameView& view, const std::vector<Match>& matches,
                const CameraSolution& solution, TakenFeatures& taken, ClusterTrack& track);
void AssociateGivenDetections(const FrameView& view, const ClusterMap& map,
                              std::vector<ClusterTrack>& tracks);
// A box of another class is not the cluster's.
void ForgetOtherCategories(const FrameView& view, const Cluster& cluster,
                           BoxProbabilities& probabilities);
std::vector<ImageBox> BoxesOf(const std::vector<Detection>& detections);
void FindBoxOfTrack(const FrameView& view, const Cluster& cluster, ClusterTrack& track);

}  // namespace internal

// What follows on a successful high-level association. Policy: descriptors in the box are compared
// with all of the cluster's landmarks and checked by the pose (paper, end of section 3.1); boxes
// left over are tried on clusters that were not found, archived ones included (`archived`: their
// predictions).
struct RematchInBox {
  static constexpr bool kInherits = true;  // InheritIdentities
  static void Rematch(const FrameView& view, const std::vector<PredictedCluster>& archived,
                      ClusterMap& map, Rng& rng, TakenFeatures& taken,
                      std::vector<ClusterTrack>& tracks);
};
// Policy: nothing.
struct NoBoxRematch {
  static constexpr bool kInherits = false;
  static void Rematch(const FrameView&, const std::vector<PredictedCluster>&, ClusterMap&, Rng&,
                      TakenFeatures&, std::vector<ClusterTrack>&) {}
};

// Multi-level association (section 3.1 of the paper): features with landmarks of the live clusters,
// detections with clusters. One track per cluster of map.live, which may grow by clusters that are
// found again.
template <typename Variant>
std::vector<ClusterTrack> AssociateClusters(const FrameView& view, ClusterMap& map, Rng& rng,
                                            TakenFeatures& taken) {
  const auto predict = [&](const Cluster& cluster) {
    return PredictCluster<typename Variant::MotionPrior, typename Variant::Rotation>(
        cluster, view.frame.timestamp_ns, view.options.motion_prior, view.options.clusters);
  };
  std::vector<PredictedCluster> archived;
  for (const Cluster& cluster : map.archived) archived.push_back(predict(cluster));
  std::vector<ClusterTrack> tracks(map.live.size());
  for (std::size_t q = 0; q < tracks.size(); ++q) {
    tracks[q].predicted = predict(map.live[q]);
    tracks[q].world_from_object = tracks[q].predicted.world_from_object;
  }
  const internal::PredictedLandmarks landmarks = internal::PredictLandmarks(view, map, tracks);
  const std::vector<Match> matches = Variant::LandmarkAssociation::Find(
      landmarks.predicted, view.grid, taken, view.options.association);
  internal::TrackClusters(view, map, landmarks.source, matches, rng, taken, tracks);

  const std::vector<ImageBox> boxes = internal::BoxesOf(view.detections);
  std::vector<BoxProbabilities> probabilities;
  for (std::size_t q = 0; q < tracks.size(); ++q) {
    probabilities.push_back(
        Variant::BoxWeights::Compute(internal::MembersOf(view, map.live[q], tracks[q]), boxes));
    internal::ForgetOtherCategories(view, map.live[q], probabilities.back());
  }
  const std::vector<int> chosen =
      AssociateBoxes(probabilities, static_cast<int>(boxes.size()), view.options.association);
  for (std::size_t q = 0; q < tracks.size(); ++q) tracks[q].detection = chosen[q];
  internal::AssociateGivenDetections(view, map, tracks);
  Variant::BoxRematch::Rematch(view, archived, map, rng, taken, tracks);
  for (std::size_t q = 0; q < tracks.size(); ++q) {
    internal::FindBoxOfTrack(view, map.live[q], tracks[q]);
  }
  return tracks;
}

}  // namespace cvo
