// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/labelling/cluster_labels.h"

namespace cvo {

// Clusters whose pose the frame shows get a state of it; detections are counted.
void AddStates(const FrameView& view, FrameId newest, const std::vector<ClusterTrack>& tracks,
               ClusterMap& map);

// After the optimisation: what the frame and those of T_t say of every live cluster goes into the
// trajectories; a cluster without a state in the frame is predicted there. Returns the reports of
// the confirmed ones.
std::vector<ClusterReport> ReportClusters(const ClusterOptions& options, FrameId newest,
                                          std::int64_t timestamp_ns,
                                          const ClusterPredictor& predict, ClusterMap& map);

std::vector<LandmarkReport> ReportLandmarks(const FrameView& view,
                                            const std::vector<FramePoint>& points,
                                            const FrameLabels& labels);

}  // namespace cvo
