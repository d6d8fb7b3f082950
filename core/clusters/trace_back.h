// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deque>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "core/association/matching.h"
#include "core/base/lists.h"
#include "core/clusters/cluster_association.h"
#include "core/estimation/cluster.h"
#include "core/features/stereo_feature.h"
#include "core/geometry/rigid_transform.h"

namespace cvo {

// Moves features that were matched with landmarks of one body to where they show the same points
// as the landmarks' reference patches, and marks them as aligned (METHOD.md 3.4). Features whose
// patches differ too much from the reference stay at their corners. `scale_factor` is the ratio of
// the scales of successive pyramid levels.
void AlignToLandmarks(double scale_factor, const RigidTransform& camera_from_object,
                      const std::vector<Landmark>& landmarks, const std::vector<Match>& matches,
                      std::span<StereoFeature> features);

// Updates the landmark's reference after an observation as `feature` at depth landmark.depth_m. The
// patch of the feature becomes the reference if there is none yet, if the feature is not aligned
// with it, or if the scale has changed by more than a factor of 1.25.
void UpdateReference(double scale_factor, const StereoFeature& feature, Landmark& landmark);

// A frame of T_t with its features, kept because a body found later may be visible in it.
struct KeptFrame {
  FrameId id;
  StereoFrame frame;
  TakenFeatures taken;  // features taken by clusters
};

// Predicts any cluster at any time after its latest state.
using PredictorAnytime =
    std::function<PredictedCluster(const Cluster& cluster, std::int64_t timestamp_ns)>;

namespace internal {

// Returns the first frame of T_t since which the cluster has been tracked without a gap; invalid if
// it is not tracked in the newest frame.
FrameId FirstTracked(const Window& window, const Cluster& cluster);
// Returns the frames of T_t before FirstTracked, latest first, back to the last one in which the
// cluster was tracked, which is excluded. Empty unless the search is due.
std::vector<FrameId> FramesToTrace(const ClusterOptions& options, const Window& window,
                                   const ClusterTrajectory& trajectory, const Cluster& cluster);
// Predicts the cluster in an earlier frame from the next two states after it, which are the last
// two when time is reversed.
PredictedCluster PredictBack(const PredictorAnytime& predict, const Cluster& cluster,
                             const KeptFrame& kept);
// Tracks the cluster in an earlier frame. Empty if too few matches agree or if their pose
// contradicts the prediction. Otherwise the inliers' features are placed (PlaceFeatures) and marked
// as taken in `kept`, as in the newest frame.
std::optional<ClusterTrack> TrackInPast(const ClusterSearch& search, const Cluster& cluster,
                                        const PredictedCluster& predicted,
                                        const PredictedLandmarks& landmarks,
                                        const std::vector<Match>& matches, Rng& rng,
                                        KeptFrame& kept);
// Adds the state, the observations and the reported pose of an earlier frame.
void AddPast(const ClusterOptions& options, const KeptFrame& kept, const ClusterTrack& track,
             Cluster& cluster, ClusterTrajectory& trajectory);

}  // namespace internal

// Tracks clusters that were found, for the first time or again, backwards through T_t until they
// are lost (METHOD.md 6.6). `show` returns what the estimator is shown of a frame's bodies.
template <LandmarkAssociationPolicy LandmarkAssociation>
void TraceBack(const ClusterSearchOptions& options, const Window& window,
               const PredictorAnytime& predict, ShownBodies (*show)(const StereoFrame&),
               std::deque<KeptFrame>& kept_frames, ClusterMap& map, Rng& rng) {
  for (Cluster& cluster : map.live) {
    ClusterTrajectory& trajectory = map.trajectories[cluster.id];
    for (const FrameId id :
         internal::FramesToTrace(options.clusters, window, trajectory, cluster)) {
      KeptFrame* kept = FindBy(kept_frames, &KeptFrame::id, id);
      if (kept == nullptr) break;
      const FeatureGrid grid(kept->frame.features, window.camera);
      const ClusterSearch search{
          {kept->frame, show(kept->frame), grid, window.camera, window.Find(id)->world_from_camera},
          options};
      const PredictedCluster predicted = internal::PredictBack(predict, cluster, *kept);
      internal::PredictedLandmarks landmarks;
      internal::PredictLandmarksOf(search, cluster, 0, predicted, landmarks);
      const auto track = internal::TrackInPast(
          search, cluster, predicted, landmarks,
          internal::FindLandmarks<LandmarkAssociation>(search, landmarks, kept->taken), rng, *kept);
      if (!track) {
        cluster.lost_before = internal::FirstTracked(window, cluster);
        break;
      }
      internal::AddPast(options.clusters, *kept, *track, cluster, trajectory);
    }
  }
}

}  // namespace cvo
