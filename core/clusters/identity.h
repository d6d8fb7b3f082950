// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/base/rng.h"
#include "core/clusters/cluster_map.h"
#include "core/clusters/cluster_prediction.h"
#include "core/interface/cluster_options.h"
#include "core/solvers/reprojection_cost.h"

namespace cvo {

// A confirmed cluster, live or archived, that is not observed in the current frame, and its
// prediction for that frame.
struct LostCluster {
  ClusterId id;
  PredictedCluster predicted;
};

std::vector<LostCluster> FindLostClusters(const ClusterOptions& options, FrameId newest,
                                          const ClusterPredictor& predict, const ClusterMap& map);

// Inputs of the identity update at the end of a frame.
struct IdentityStep {
  const ClusterAssociationOptions& association;
  const ClusterOptions& clusters;
  FrameId newest;
  const ClusterPredictor& predict;  // at the time of the frame
};

// Lets a new cluster continue a lost cluster of its class that explains its position and size, if
// enough of its landmarks are also landmarks of the lost one (METHOD.md 6.5). The cluster is then
// expressed in the object frame of the lost one and gets its id and its landmarks. Without such
// landmarks, the new frame cannot be placed in the former one, and the cluster keeps its own id.
void InheritIdentities(const IdentityStep& step, const std::vector<LostCluster>& lost,
                       ClusterMap& map, Rng& rng);

template <typename Policy>
concept IdentityPolicy = requires(const IdentityStep& step, ClusterMap& map, Rng& rng) {
  Policy::Update(step, map, rng);
};

// Policy: a new cluster may continue a lost one (InheritIdentities).
struct InheritLostIdentity {
  static void Update(const IdentityStep& step, ClusterMap& map, Rng& rng);
};
// Policy: a new cluster never continues a lost one.
struct AlwaysNewIdentity {
  static void Update(const IdentityStep&, ClusterMap&, Rng&) {}
};
}  // namespace cvo
