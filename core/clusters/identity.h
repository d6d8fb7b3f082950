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
  const MotionPriorOptions& motion;
  FrameId newest;
  const ClusterPredictor& predict;  // at the time of the frame
};

// Lets a cluster confirmed in this frame continue under the id of a lost cluster of its class that
// explains its position and size, if no other explains them nearly as well: a body that turned
// while it was hidden shows none of its old landmarks. The cluster is then expressed in the object
// frame of the lost one, placed by the motions before and after the loss and by the boxes
// (METHOD.md 6.5).
void InheritIdentities(const IdentityStep& step, const std::vector<LostCluster>& lost,
                       ClusterMap& map);

// Aligns the object frames of clusters that continue under an earlier id with their former frames,
// by landmarks with similar descriptors. Until that succeeds, and up to 15 boxes,
// every frame places them anew by the motions and the centres that the boxes show.
void AlignInheritedFrames(const IdentityStep& step, ClusterMap& map, Rng& rng);

template <typename Policy>
concept IdentityPolicy = requires(const IdentityStep& step, ClusterMap& map, Rng& rng) {
  Policy::Update(step, map, rng);
};

// Policy: a newly confirmed cluster may continue a lost one (InheritIdentities), and is aligned
// with it (AlignInheritedFrames).
struct InheritLostIdentity {
  static void Update(const IdentityStep& step, ClusterMap& map, Rng& rng);
};
// Policy: a newly confirmed cluster never continues a lost one.
struct AlwaysNewIdentity {
  static void Update(const IdentityStep&, ClusterMap&, Rng&) {}
};
}  // namespace cvo
