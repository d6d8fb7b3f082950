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

// Policies that match clusters by descriptors alone, without a prediction, in the boxes that were
// assigned to them (paper, end of section 3.1), and then decide on the boxes of clusters that were
// not found.

// Policy: compares the descriptors in the box with those of the cluster's unmatched landmarks and
// keeps the matches that agree on a pose. A cluster that was not found keeps its box, and gets new
// landmarks there at its predicted pose, only while it is new or this pose is known to a third of
// the body's size (METHOD.md 4.6); else the box is released.
struct RematchInBox {
  static void Rematch(const FrameView& view, const ClusterMap& map, Rng& rng, TakenFeatures& taken,
                      std::vector<ClusterTrack>& tracks);
};
// Policy: the same, but the box is kept in any case (the relaunch of the paper's section 4.2).
struct RematchAndRelaunch {
  static void Rematch(const FrameView& view, const ClusterMap& map, Rng& rng, TakenFeatures& taken,
                      std::vector<ClusterTrack>& tracks);
};
// Policy: no matching without a prediction.
struct NoBoxRematch {
  static void Rematch(const FrameView&, const ClusterMap&, Rng&, TakenFeatures&,
                      std::vector<ClusterTrack>& tracks);
};

using LandmarkSearch = std::vector<Match>(std::span<const PredictedLandmark>, const FeatureGrid&,
                                          const TakenFeatures&, const ClusterAssociationOptions&);

// The steps of the association in which variants differ.
struct AssociationSteps {
  LandmarkSearch* find;
  BoxProbabilities (*weigh)(std::span<const PredictedLandmark>, std::span<const ImageBox>);
  double (*box_cost)(double p, double share);
  bool compares_classes;
  void (*rematch)(const FrameView&, const ClusterMap&, Rng&, TakenFeatures&,
                  std::vector<ClusterTrack>&);
};

// Appends the landmarks of cluster q that are predicted to be visible.
void PredictLandmarksOf(const FrameView& view, const Cluster& cluster, int q,
                        const PredictedCluster& at, std::vector<PredictedLandmark>& landmarks);
// Returns matches whose `landmark` is an index into `landmarks`.
std::vector<Match> FindLandmarks(const FrameView& view, LandmarkSearch& find,
                                 std::span<const PredictedLandmark> landmarks,
                                 const TakenFeatures& taken);

// Multi-level association (section 3.1 of the paper): features with landmarks of the live clusters,
// then detections with clusters. Returns one track per cluster in map.live.
std::vector<ClusterTrack> AssociateClusters(const FrameView& view, FrameId newest,
                                            const AssociationSteps& steps,
                                            const ClusterPredictor& predict, const ClusterMap& map,
                                            Rng& rng, TakenFeatures& taken);

}  // namespace cvo
