// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/estimation/cluster.h"

#include <algorithm>

namespace cvo {

const ClusterState* FindState(const Cluster& cluster, FrameId frame) {
  const auto it = std::lower_bound(cluster.states.begin(), cluster.states.end(), frame,
                                   [](const ClusterState& s, FrameId id) { return s.frame < id; });
  return it != cluster.states.end() && it->frame == frame ? &*it : nullptr;
}

}  // namespace cvo
