// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/runner/score_run.h"

#include <map>
#include <optional>
#include <string>
#include <utility>

#include "experiments/metrics/camera_metrics.h"
#include "experiments/metrics/kitti_ap/box_metrics.h"
#include "experiments/metrics/objects/clustering_metrics.h"
#include "experiments/metrics/objects/object_metrics.h"
#include "experiments/record/cluster_rows.h"
#include "experiments/record/cluster_tables.h"

namespace cvo {
namespace {

void Append(std::vector<Metric> from, std::vector<Metric>& to) {
  for (Metric& metric : from) to.push_back(std::move(metric));
}

// "camera_ate" is "camera_causal_ate"; without what has no such form.
void NameCausal(std::vector<Metric>& metrics) {
  std::erase_if(metrics, [](const Metric& metric) {
    return reports::MaxDriftIndex(reports::FindForm(metric.name).value().id).has_value();
  });
  for (Metric& metric : metrics) {
    reports::MetricForm form = reports::FindForm(metric.name).value();
    form.causal = true;
    metric.name = reports::MetricName(form);
  }
}

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

RunScores ScoreRun(const Sequence& sequence, const RunResult& run, const ObjectTruth* objects) {
  if (run.status == RunStatus::kFailed) return {};
  ObjectEstimate refined = ObjectEstimateOf(run, PoseTime::kRefined);
  ObjectEstimate causal = ObjectEstimateOf(run, PoseTime::kCausal);
  const bool by_landmarks = objects != nullptr && objects->tells_pixels;
  if (!by_landmarks) refined.match_by = causal.match_by = MatchBy::kNearness;
  const auto camera = [&sequence](const ObjectEstimate& estimate) {
    return EvaluateCamera(sequence.groundtruth_world_from_camera, estimate.world_from_camera,
                          EnumOf<reports::TruthSource>(sequence.groundtruth));
  };
  RunScores scores;
  scores.refined = camera(refined);
  scores.causal = camera(causal);
  scores.truth_from_estimate =
      AlignByCamera(sequence.groundtruth_world_from_camera, refined.world_from_camera);
  if (objects != nullptr) {
    ObjectScores of_refined = ScoreObjects(*objects, refined);
    ObjectScores of_causal = ScoreObjects(*objects, causal);
    Append(ObjectMetrics(*objects, of_refined), scores.refined);
    Append(ObjectMetrics(*objects, of_causal), scores.causal);
    if (by_landmarks) {
      scores.clustering = ClusteringMetrics(*objects, causal, MatchObjects(*objects, causal));
    }
    scores.refined_bodies = std::move(of_refined.bodies);
    scores.causal_bodies = std::move(of_causal.bodies);
  }
  scores.boxes = BoxMetrics(sequence, TrackBoxes(sequence, run));
  const double shift_px = sequence.camera.right_shift_px;
  StatePoses(reports::PoseTime::kRefined, shift_px, scores.refined);
  StatePoses(reports::PoseTime::kCausal, shift_px, scores.causal);
  StatePoses(reports::PoseTime::kCausal, shift_px, scores.clustering);
  StatePoses(reports::PoseTime::kRefined, shift_px, scores.boxes);
  NameCausal(scores.causal);
  return scores;
}

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
