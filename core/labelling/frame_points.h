// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/association/match.h"
#include "core/clusters/cluster_association.h"
#include "core/estimation/window.h"

namespace cvo {

// A feature of the current frame and the landmark it shows.
struct FramePoint {
  static constexpr int kNoBody = -1;     // no landmark yet
  static constexpr int kStaticBody = 0;  // window.landmarks
  int feature = 0;
  int body = kNoBody;  // q + 1: map.live[q].landmarks
  int landmark = -1;   // index there
};

// Features that may show the static scene: all but those of the reserve that are in no detection,
// for more of a scene that has enough costs time and brings it nothing.
std::vector<int> SceneFeatures(const std::vector<StereoFeature>& features,
                               const std::vector<Detection>& detections);

// Every feature that has the disparity for a landmark, by feature: those matched with the static
// scene, those matched with clusters, and those that are new; of the reserve only new ones where a
// detection or a cluster is.
std::vector<FramePoint> CollectPoints(const FrameView& view,
                                      const std::vector<Match>& static_matches,
                                      const std::vector<ClusterTrack>& tracks);

// The landmark of a point; null where it has none.
const Landmark* FindLandmark(const FramePoint& point, const Window& window, const ClusterMap& map);

// The body's pose in a frame of the window, world_from_body: the identity for the static scene,
// empty where a cluster has no state.
std::optional<RigidTransform> BodyPose(int body, FrameId frame, const ClusterMap& map);

}  // namespace cvo
