// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/association/image_box.h"
#include "core/association/match.h"
#include "core/clusters/cluster_map.h"
#include "core/clusters/cluster_prediction.h"

namespace cvo {

// Result of the association for one live cluster in the current frame.
struct ClusterTrack {
  PredictedCluster predicted;
  RigidTransform world_from_object;  // provisional P_t^q if is_tracked, otherwise predicted
  bool is_tracked = false;           // has a pose from at least min_tracked inliers
  std::vector<Match> matches;        // inliers: index into cluster.landmarks, feature
  int detection = -1;                // index into the frame's detections; -1: none
  ImageBox box;                      // around its matched or predicted landmarks; unset if detected
};

}  // namespace cvo
