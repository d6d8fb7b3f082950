// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/runner/object_estimate_of.h"

#include <map>
#include <utility>

#include "experiments/record/cluster_rows.h"

namespace cvo {
namespace {

ClusterFrame FrameOf(const ClusterRow& row, std::size_t frame, PoseTime time) {
  const bool refined = time == PoseTime::kRefined && row.refined != nullptr;
  ClusterFrame cluster;
  cluster.frame = static_cast<int>(frame);
  cluster.world_from_object =
      refined ? row.refined->world_from_object : row.report.world_from_object;
  // Of the cluster's origin, as point_in_object is.
  cluster.velocity_m_s = refined ? row.refined->velocity_m_s : row.report.velocity_m_s;
  cluster.observed_landmarks = row.report.observed_landmarks;
  cluster.predicted = row.report.status == ClusterStatus::kPredicted;
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
    ClusterEstimate& cluster = clusters[row.report.id];
    cluster.id = row.report.id.value;
    cluster.category = row.report.category;
    const auto frame = static_cast<std::size_t>(row.frame.frame - run.frames.front().frame);
    cluster.frames.push_back(FrameOf(row, frame, time));
  }
  for (auto& [id, cluster] : clusters) estimate.clusters.push_back(std::move(cluster));
  return estimate;
}

}  // namespace cvo
