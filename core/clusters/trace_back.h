// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deque>
#include <functional>
#include <span>
#include <vector>

#include "core/association/matching.h"
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

// Inputs of TraceBack.
struct TraceBackStep {
  const Options& options;
  const Window& window;
  PredictorAnytime predict;
  ShownBodies (*show)(StereoFrame&);  // what the estimator is shown of a frame's bodies
  LandmarkSearch* find;
};

// Tracks clusters that were found, for the first time or again, backwards through T_t until they
// are lost (METHOD.md 6.5).
void TraceBack(const TraceBackStep& step, std::deque<KeptFrame>& kept_frames, ClusterMap& map,
               Rng& rng);

}  // namespace cvo
