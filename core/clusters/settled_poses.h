// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/clusters/cluster_map.h"

namespace cvo {

// Takes the poses out of the trajectories that no later frame changes, by id, so that what is kept
// of a run does not grow with its length. Frames of T_t are still estimated and traced back into;
// so are those of a cluster's states. What a cluster did since it was found again changes until its
// frame is aligned, and one that is yet to be confirmed may turn out to be any lost one.
std::vector<ClusterTrajectory> TakeSettledPoses(const Window& window, const ClusterOptions& options,
                                                ClusterMap& map);

}  // namespace cvo
