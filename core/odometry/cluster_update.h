// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/labelling/cluster_labels.h"

namespace cvo {

namespace internal {

ClusterReport DescribeCluster(const Options& options, FrameId newest, const Cluster& cluster);
// Overwrites the poses of the cluster's states and appends the frame's.
void RecordTrajectory(const Cluster& cluster, const ClusterReport& report, FrameId newest,
                      std::int64_t timestamp_ns, ClusterTrajectory& trajectory);

}  // namespace internal

// Clusters whose pose the frame shows get a state of it; detections are counted.
void AddStates(const FrameView& view, FrameId newest, const std::vector<ClusterTrack>& tracks,
               ClusterMap& map);

// After the optimisation: what the frame and those of T_t say of every live cluster goes into the
// trajectories; a cluster without a state in the frame is predicted there. Returns the reports of
// the confirmed ones.
template <typename Variant>
std::vector<ClusterReport> ReportClusters(const Options& options, FrameId newest,
                                          std::int64_t timestamp_ns, ClusterMap& map) {
  std::vector<ClusterReport> reports;
  for (const Cluster& cluster : map.live) {
    ClusterReport report = internal::DescribeCluster(options, newest, cluster);
    if (cluster.Latest().frame < newest) {
      const PredictedCluster predicted =
          PredictCluster<typename Variant::MotionPrior, typename Variant::Rotation>(
              cluster, timestamp_ns, options.motion_prior, options.clusters);
      report.world_from_object = predicted.world_from_object;
      report.velocity_m_s = predicted.velocity_m_s;
    }
    internal::RecordTrajectory(cluster, report, newest, timestamp_ns, map.trajectories[cluster.id]);
    if (IsConfirmed(cluster, options.clusters)) reports.push_back(std::move(report));
  }
  return reports;
}

std::vector<LandmarkReport> ReportLandmarks(const FrameView& view,
                                            const std::vector<FramePoint>& points,
                                            const FrameLabels& labels);

}  // namespace cvo
