// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/association/match.h"
#include "core/clusters/cluster_track.h"
#include "core/estimation/window.h"

namespace cvo {

// Owner of a point's landmark: none yet, the static scene (window.landmarks) or a live cluster
// (map.live[cluster].landmarks).
struct PointOwner {
  enum class Kind { kUnassigned, kScene, kCluster };
  Kind kind = Kind::kUnassigned;
  int cluster = -1;

  friend constexpr bool operator==(const PointOwner&, const PointOwner&) = default;
};
inline constexpr PointOwner kNoOwner{};
inline constexpr PointOwner kSceneOwner{PointOwner::Kind::kScene, -1};
constexpr PointOwner ClusterOwner(int cluster) { return {PointOwner::Kind::kCluster, cluster}; }

// A feature of the current frame and the landmark that it observes.
struct FramePoint {
  int feature = 0;
  PointOwner owner;
  int landmark = -1;  // index into the owner's landmarks
};

// Returns the indices of features that may show the static scene: all except those found in the
// left image only and reserve features outside all detections, which would cost time without
// improving a scene that has enough features.
std::vector<int> SceneFeatures(const std::vector<StereoFeature>& features,
                               std::span<const Detection> detections);

// Returns, in the order of the features, all that are matched with the static scene or with
// clusters, and all new ones that may become landmarks: those found in the right image with a
// disparity of at least min_disparity_px; of the reserve, only those inside a detection or the
// expected box of a cluster.
std::vector<FramePoint> CollectPoints(const FrameView& view, double min_disparity_px,
                                      const std::vector<Match>& static_matches,
                                      const std::vector<ClusterTrack>& tracks);

// Returns the landmark of a point; null if it has none.
const Landmark* FindLandmark(const FramePoint& point, const Window& window, const ClusterMap& map);

// Returns world_from_object of the owner in a frame of the window: the identity for the static
// scene, empty for a cluster without a state in that frame.
std::optional<RigidTransform> OwnerPose(PointOwner owner, FrameId frame, const ClusterMap& map);

}  // namespace cvo
