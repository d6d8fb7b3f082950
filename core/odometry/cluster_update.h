// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/bodies/box_center.h"
#include "core/labelling/cluster_labels.h"

namespace cvo {

// Clusters whose pose the frame shows get a state of it; detections are counted.
void AddStates(const FrameView& view, const BodyCenterOptions& options, FrameId newest,
               const std::vector<ClusterTrack>& tracks, ClusterMap& map);

// After the optimisation: every live cluster in the newest frame, boxes and scores left out; one
// without a state in the frame is predicted there.
std::vector<ClusterReport> DescribeClusters(const ClusterOptions& options, FrameId newest,
                                            const ClusterPredictor& predict, const ClusterMap& map);

// The reports of all live clusters, and the poses of T_t as they are now, go into the trajectories.
// Returns those of the confirmed ones.
std::vector<ClusterReport> RecordClusters(const ClusterOptions& options, FrameId newest,
                                          std::int64_t timestamp_ns,
                                          std::vector<ClusterReport> reports, ClusterMap& map);

std::vector<LandmarkReport> ReportLandmarks(const FrameView& view,
                                            const std::vector<FramePoint>& points,
                                            const FrameLabels& labels);

}  // namespace cvo
