// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/rng.h"
#include "core/clusters/cluster_map.h"
#include "core/clusters/cluster_prediction.h"

namespace cvo {

// Inputs of the identity update at the end of a frame.
struct IdentityStep {
  const Options& options;
  FrameId newest;
  const ClusterPredictor& predict;  // at the time of the frame
};

// Policy: a new cluster continues a lost one of its class if enough of its landmarks are also
// landmarks of the lost one, which can have moved there (METHOD.md 6.5). It is then expressed in
// the object frame of the lost one and gets its id and its landmarks. Without such landmarks, the
// new frame cannot be placed in the former one, and the cluster keeps its own id.
struct InheritLostIdentity {
  static void Update(const IdentityStep& step, ClusterMap& map, Rng& rng);
};
// Policy: a new cluster never continues a lost one.
struct AlwaysNewIdentity {
  static void Update(const IdentityStep&, ClusterMap&, Rng&) {}
};

}  // namespace cvo
