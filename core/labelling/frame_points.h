// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/association/matching.h"
#include "core/clustering/dense_crf.h"
#include "core/clustering/point_extent.h"
#include "core/clusters/cluster_prediction.h"
#include "core/estimation/window.h"

namespace cvo {

// Owner of a landmark: an index into map.live, or one of these.
inline constexpr int kNoOwner = -2;
inline constexpr int kSceneOwner = -1;  // the static scene: window.landmarks

// A feature of the current frame and the landmark that it observes.
struct FramePoint {
  int feature = 0;
  int owner = kNoOwner;
  int landmark = -1;  // index into the owner's landmarks
};

// Whether the feature lies in the box of a detection.
bool IsDetected(std::span<const Detection> detections, const StereoFeature& feature);

// Returns the indices of features that may show the static scene: all except those found in the
// left image only and reserve features outside all detections, which would cost time without
// improving a scene that has enough features.
std::vector<int> SceneFeatures(const std::vector<StereoFeature>& features,
                               std::span<const Detection> detections);

// Returns, in the order of the features, all that are matched with the static scene or with
// clusters, and all new ones that may become landmarks: those found in the right image with a
// disparity of at least tracking.min_disparity_px; of the reserve, only those inside a detection or
// the expected box of a cluster.
std::vector<FramePoint> CollectPoints(const FrameView& view,
                                      const std::vector<Match>& static_matches,
                                      const std::vector<ClusterTrack>& tracks);

// Returns the landmark of a point; null if it has none.
const Landmark* FindLandmark(const FramePoint& point, const Window& window, const ClusterMap& map);

// Returns world_from_object of the owner in a frame of the window: the identity for the static
// scene, empty for a cluster without a state in that frame.
std::optional<RigidTransform> OwnerPose(int owner, FrameId frame, const ClusterMap& map);

// Policies for which of the points in a box that no cluster claims may be the body: candidate sets
// of points by depth, in order of preference, as DepthModes.

// Policy: the dense ranges of depths, nearest first (METHOD.md 6.2).
struct BodiesByDepth {
  static std::vector<std::vector<int>> Candidates(const std::vector<double>& depths_m,
                                                  double angular_size) {
    return DepthModes(depths_m, angular_size);
  }
};
// Policy: the paper's, all points, if there are at least kModeMinPoints.
struct BodiesOfAllPoints {
  static std::vector<std::vector<int>> Candidates(const std::vector<double>& depths_m, double);
};

// One of these policies.
using NewBodyRule = std::vector<std::vector<int>> (*)(const std::vector<double>&, double);

// Returns the extent of the body in a box that no cluster claims, from those of its points that
// belong to no cluster: of the first candidate that is spread over enough of the box. Empty if
// there is none. `nodes` has one entry per point.
std::optional<CrfLabel::Extent> FindNewBody(const FrameView& view, NewBodyRule candidates_of,
                                            const ImageBox& box,
                                            const std::vector<FramePoint>& points,
                                            const std::vector<CrfNode>& nodes);

}  // namespace cvo
