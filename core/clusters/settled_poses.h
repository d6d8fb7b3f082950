// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/clusters/cluster_map.h"

namespace cvo {

// Removes from the trajectories all poses that no later frame can change and returns them, sorted
// by id, so that memory does not grow with the length of a run. Poses may still change
//  - in frames of T_t and of the cluster's states, which are still estimated or traced back into,
//  - since the cluster was found again, until its object frame is aligned,
//  - since the first pose of any unconfirmed cluster, which may still turn out to be a lost one.
std::vector<ClusterTrajectory> TakeSettledPoses(const Window& window, const ClusterOptions& options,
                                                ClusterMap& map);

}  // namespace cvo
