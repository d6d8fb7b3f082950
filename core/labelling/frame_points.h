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

// Whose landmark a point is: nobody's yet, the static scene's (window.landmarks) or a live
// cluster's (map.live[cluster].landmarks).
struct PointOwner {
  enum class Kind { kUnassigned, kScene, kCluster };
  Kind kind = Kind::kUnassigned;
  int cluster = -1;

  friend constexpr bool operator==(const PointOwner&, const PointOwner&) = default;
};
inline constexpr PointOwner kNoOwner{};
inline constexpr PointOwner kSceneOwner{PointOwner::Kind::kScene, -1};
constexpr PointOwner ClusterOwner(int cluster) { return {PointOwner::Kind::kCluster, cluster}; }

// A feature of the current frame and the landmark it shows.
struct FramePoint {
  int feature = 0;
  PointOwner owner;
  int landmark = -1;  // index among the owner's
};

// Features that may show the static scene: all but those of the reserve that are in no detection,
// for more of a scene that has enough costs time and brings it nothing.
std::vector<int> SceneFeatures(const std::vector<StereoFeature>& features,
                               std::span<const Detection> detections);

// Every feature that has the disparity for a landmark, by feature: those matched with the static
// scene, those matched with clusters, and those that are new; of the reserve only new ones where a
// detection or a cluster is.
std::vector<FramePoint> CollectPoints(const FrameView& view, double min_disparity_px,
                                      const std::vector<Match>& static_matches,
                                      const std::vector<ClusterTrack>& tracks);

// The landmark of a point; null where it has none.
const Landmark* FindLandmark(const FramePoint& point, const Window& window, const ClusterMap& map);

// world_from_object of the owner in a frame of the window: the identity for the static scene, empty
// where a cluster has no state.
std::optional<RigidTransform> OwnerPose(PointOwner owner, FrameId frame, const ClusterMap& map);

}  // namespace cvo
