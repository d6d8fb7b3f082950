// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/runner/object_estimate_of.h"

#include <map>
#include <utility>

#include "experiments/record/cluster_rows.h"

namespace cvo {
namespace {

ClusterFrame FrameOf(const ClusterReport& report, std::size_t frame) {
  ClusterFrame cluster;
  cluster.frame = static_cast<int>(frame);
  cluster.world_from_object = report.world_from_object;
  // Of the cluster's origin, as point_in_object is.
  cluster.velocity_m_s = report.velocity_m_s;
  cluster.observed_landmarks = report.observed_landmarks;
  cluster.predicted = report.status == ClusterStatus::kPredicted;
  return cluster;
}

}  // namespace

ObjectEstimate ObjectEstimateOf(const RunResult& run, PoseTime time) {
  ObjectEstimate estimate;
  for (const FrameRecord& frame : run.frames) {
    const RigidTransform& pose = time == PoseTime::kCausal ? frame.report.world_from_camera
                                                           : frame.refined_world_from_camera;
    const bool skipped = frame.report.status == FrameStatus::kSkipped;
    estimate.world_from_camera.push_back(skipped ? std::nullopt : std::optional(pose));
    estimate.landmarks.push_back(frame.landmarks);
  }
  std::map<ClusterId, ClusterEstimate> clusters;
  for (const ClusterRow& row : ClusterRows(run)) {
    const ClusterReport* report = time == PoseTime::kCausal ? row.causal : &row.Last();
    if (!report) continue;
    ClusterEstimate& cluster = clusters[row.id];
    cluster.id = row.id.value;
    cluster.category = report->category;
    const auto frame = static_cast<std::size_t>(row.frame.frame - run.frames.front().frame);
    cluster.frames.push_back(FrameOf(*report, frame));
  }
  for (auto& [id, cluster] : clusters) estimate.clusters.push_back(std::move(cluster));
  return estimate;
}

}  // namespace cvo
