// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/clusters/cluster_optimization.h"
#include "core/clusters/cluster_prediction.h"
#include "core/estimation/window.h"
#include "core/estimation/window_problem.h"
#include "core/interface/frame.h"

namespace cvo {

// Policies for the detections, and the given knowledge of bodies, that the estimator is shown.

// Policy: all those of the frame.
struct UseDetections {
  static ShownBodies Show(StereoFrame& frame) {
    return {frame.detections, frame.given.feature_body, frame.given.detection_body};
  }
};
// Policy: none. No cluster is ever found, and the world is assumed to be static.
struct IgnoreDetections {
  static ShownBodies Show(StereoFrame&) { return {}; }
};
// Policy: none, and features in detections lose their disparity: the static scene has no others.
struct MaskDetections {
  static ShownBodies Show(StereoFrame& frame);
};

// Bundle adjustment of the window (static energy of section 3.3 of the paper). The oldest frame is
// held fixed (METHOD.md 7.4). Removes observations whose squared whitened error exceeds the gate of
// the variant, then landmarks without observations. Sets what `report` says of the window.
void OptimizeWindow(const Options& options, const EnergySteps& steps, const RowField& rows,
                    Window& window, FrameReport& report);

// Updates the clusters from their tracks in the frame: a tracked cluster gets a state for it, and
// associated detections are counted.
void AddStates(const FrameView& view, FrameId newest, const std::vector<ClusterTrack>& tracks,
               ClusterMap& map);

// Describes every live cluster in the newest frame, after the optimisation and without boxes and
// scores. A cluster without a state in the frame is predicted.
std::vector<ClusterReport> DescribeClusters(FrameId newest, const ClusterPredictor& predict,
                                            const ClusterMap& map);

// Appends the reports of all live clusters to their trajectories, and updates the poses of T_t
// there. Returns the reports of the confirmed clusters.
std::vector<ClusterReport> RecordClusters(const ClusterOptions& options, FrameId newest,
                                          std::int64_t timestamp_ns,
                                          std::vector<ClusterReport> reports, ClusterMap& map);

}  // namespace cvo
