// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/base/rng.h"
#include "core/clusters/cluster_map.h"
#include "core/clusters/cluster_prediction.h"
#include "core/interface/identity_options.h"

namespace cvo {

// A confirmed cluster that is out of sight, live or archived, as predicted for now.
struct LostCluster {
  ClusterId id;
  PredictedCluster predicted;
};

std::vector<LostCluster> FindLostClusters(const ClusterOptions& options, FrameId newest,
                                          const ClusterPredictor& predict, const ClusterMap& map);

// What updates of cluster identities at the end of a frame read.
struct IdentityStep {
  const IdentityOptions& identity;
  const ClusterAssociationOptions& association;
  const ClusterOptions& clusters;
  const MotionPriorOptions& motion;
  FrameId newest;
  const ClusterPredictor& predict;  // for the frame's time
};

// Clusters confirmed in this frame whose place and size one lost cluster of their class explains,
// and no other nearly as well, go on under its id: a body that turned while it was hidden shows
// none of its old landmarks. Their frame becomes the lost one's, where the motions before and after
// the loss and the boxes place it.
void InheritIdentities(const IdentityStep& step, const std::vector<LostCluster>& lost,
                       ClusterMap& map);

// Clusters that go on under an earlier id: their frame is aligned with what it was, by landmarks
// that look alike, until then, after enough boxes, by the motions and the centres that they show.
void AlignInheritedFrames(const IdentityStep& step, ClusterMap& map, Rng& rng);

template <typename Policy>
concept IdentityPolicy = requires(const IdentityStep& step, ClusterMap& map, Rng& rng) {
  Policy::Update(step, map, rng);
};

// Policy: a found cluster may go on as a lost one (InheritIdentities).
struct InheritLostIdentity {
  static void Update(const IdentityStep& step, ClusterMap& map, Rng& rng);
};
// Policy: a found cluster is always a new one.
struct AlwaysNewIdentity {
  static void Update(const IdentityStep&, ClusterMap&, Rng&) {}
};
// Policy: another one, and the frame of what goes on as a lost cluster is aligned with what it was
// (AlignInheritedFrames).
template <IdentityPolicy Identity>
struct WithAlignedFrames {
  static void Update(const IdentityStep& step, ClusterMap& map, Rng& rng) {
    Identity::Update(step, map, rng);
    AlignInheritedFrames(step, map, rng);
  }
};

}  // namespace cvo
