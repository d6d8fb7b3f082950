// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/bodies/box_center.h"
#include "core/labelling/cluster_labels.h"

namespace cvo {

// Updates the clusters from their tracks in the frame: a tracked cluster gets a state for it, and
// associated detections are counted.
void AddStates(const FrameView& view, const BodyCenterOptions& options, FrameId newest,
               const std::vector<ClusterTrack>& tracks, ClusterMap& map);

// Describes every live cluster in the newest frame, after the optimisation and without boxes and
// scores. A cluster without a state in the frame is predicted.
std::vector<ClusterReport> DescribeClusters(const ClusterOptions& options, FrameId newest,
                                            const ClusterPredictor& predict, const ClusterMap& map);

// Appends the reports of all live clusters to their trajectories, and updates the poses of T_t
// there. Returns the reports of the confirmed clusters.
std::vector<ClusterReport> RecordClusters(const ClusterOptions& options, FrameId newest,
                                          std::int64_t timestamp_ns,
                                          std::vector<ClusterReport> reports, ClusterMap& map);

std::vector<LandmarkReport> ReportLandmarks(const FrameView& view,
                                            const std::vector<FramePoint>& points,
                                            const FrameLabels& labels);

}  // namespace cvo
