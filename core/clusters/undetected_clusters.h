// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/clusters/cluster_map.h"
#include "core/solvers/measurement_noise.h"

namespace cvo {

// Whether the cluster stands still, as far as T_t shows: of its landmarks that the newest frame and
// an earlier one of T_t observe, at least half have not moved beyond noise.gate since the earliest.
// False without such landmarks.
bool StandsStill(const Window& window, const FeatureNoise& noise, FrameId newest,
                 const Cluster& cluster);

// Archives confirmed clusters that stand still and have not been detected for
// options.undetected_frames frames: most come from a false detection that lasted for a few frames
// and hold points of the static scene (METHOD.md 6.4). Given bodies stay.
void ArchiveUndetected(const Window& window, const FeatureNoise& noise, FrameId newest,
                       const ClusterOptions& options, ClusterMap& map);

}  // namespace cvo
