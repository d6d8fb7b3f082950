// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/runner/score_run.h"

#include <map>
#include <optional>
#include <string>
#include <utility>

#include "experiments/metrics/boxes/average_precision.h"
#include "experiments/metrics/camera_metrics.h"
#include "experiments/metrics/objects/object_scores.h"
#include "experiments/runner/result_file.h"
#include "experiments/runner/run_result.h"
#include "experiments/runner/run_tables.h"

namespace cvo {
namespace {

void Append(std::vector<Metric> from, std::vector<Metric>& to) {
  for (Metric& metric : from) to.push_back(std::move(metric));
}

// Renames metrics to their causal form, for example "camera_ate" to "camera_causal_ate". Removes
// those that have no such form.
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
  // The velocity is that of the cluster's origin, as is point_in_object.
  cluster.velocity_m_s = report.velocity_m_s;
  cluster.observed_landmarks = report.observed_landmarks;
  cluster.predicted = report.status == ClusterStatus::kPredicted;
  return cluster;
}

// Returns whether clusters are matched to bodies by landmarks; otherwise selects nearness.
bool MatchByTruth(const ObjectTruth* objects, ObjectEstimate& estimate) {
  const bool by_landmarks = objects != nullptr && objects->tells_pixels;
  if (!by_landmarks) estimate.match_by = MatchBy::kNearness;
  return by_landmarks;
}

std::vector<Metric> CameraMetrics(const Sequence& sequence, const ObjectEstimate& estimate) {
  return EvaluateCamera(sequence.groundtruth_world_from_camera, estimate.world_from_camera,
                        EnumOf<reports::TruthSource>(sequence.groundtruth));
}

void ScoreRefined(const Sequence& sequence, ObjectEstimate refined, const ObjectTruth* objects,
                  RunScores& scores) {
  MatchByTruth(objects, refined);
  scores.refined = CameraMetrics(sequence, refined);
  scores.truth_from_estimate =
      AlignByCamera(sequence.groundtruth_world_from_camera, refined.world_from_camera);
  if (objects == nullptr) return;
  ObjectScores of_refined = ScoreObjects(*objects, refined);
  Append(ObjectMetrics(*objects, of_refined), scores.refined);
  scores.refined_bodies = std::move(of_refined.bodies);
}

void ScoreCausal(const Sequence& sequence, ObjectEstimate causal, const ObjectTruth* objects,
                 RunScores& scores) {
  const bool by_landmarks = MatchByTruth(objects, causal);
  scores.causal = CameraMetrics(sequence, causal);
  if (objects == nullptr) return;
  ObjectScores of_causal = ScoreObjects(*objects, causal);
  Append(ObjectMetrics(*objects, of_causal), scores.causal);
  if (by_landmarks) {
    scores.clustering = ClusteringMetrics(*objects, causal, MatchObjects(*objects, causal));
  }
  scores.causal_bodies = std::move(of_causal.bodies);
}

}  // namespace

RunScores ScoreRun(const Sequence& sequence, const RunResult& run, const RunTruth& truth) {
  if (run.status == RunStatus::kFailed) return {};
  RunScores scores;
  // The estimates are made one after the other, as each holds all poses of a run.
  ScoreRefined(sequence, ObjectEstimateOf(run, PoseTime::kRefined), truth.objects, scores);
  ScoreCausal(sequence, ObjectEstimateOf(run, PoseTime::kCausal), truth.objects, scores);
  if (TellsBoxes(sequence)) {
    std::vector<ObjectBox> boxes;
    ForEachTrackBox(sequence, run, [&boxes](const ObjectBox& box) { boxes.push_back(box); });
    scores.boxes = BoxMetrics(sequence, boxes);
  }
  const std::optional<CalibrationReport> found = LastCalibration(run);
  if (found && truth.right_field_px) {
    scores.calibration = EvaluateCalibration(*truth.right_field_px, *found);
  }
  const double shift_px = sequence.camera.right_shift_px;
  StatePoses(reports::PoseTime::kRefined, shift_px, scores.refined);
  StatePoses(reports::PoseTime::kCausal, shift_px, scores.causal);
  StatePoses(reports::PoseTime::kCausal, shift_px, scores.clustering);
  StatePoses(reports::PoseTime::kRefined, shift_px, scores.boxes);
  StatePoses(reports::PoseTime::kCausal, shift_px, scores.calibration);
  NameCausal(scores.causal);
  return scores;
}

ObjectEstimate ObjectEstimateOf(const RunResult& run, PoseTime time) {
  ObjectEstimate estimate;
  int first_frame = 0;
  for (const FrameRecord& frame : run.frames) {
    if (estimate.landmarks.empty()) first_frame = frame.frame;
    const RigidTransform& pose = time == PoseTime::kCausal ? frame.report.world_from_camera
                                                           : frame.refined_world_from_camera;
    const bool skipped = frame.report.status == FrameStatus::kSkipped;
    estimate.world_from_camera.push_back(skipped ? std::nullopt : std::optional(pose));
    estimate.landmarks.push_back(frame.landmarks);
  }
  std::map<ClusterId, ClusterEstimate> clusters;
  ForEachLiveCluster(run, [&](const LiveCluster& row) {
    const ClusterReport* report = time == PoseTime::kCausal ? row.causal : &row.Last();
    if (!report) return;
    ClusterEstimate& cluster = clusters[row.id];
    cluster.id = row.id.value;
    cluster.category = report->category;
    cluster.frames.push_back(
        FrameOf(*report, static_cast<std::size_t>(row.frame.frame - first_frame)));
  });
  for (auto& [id, cluster] : clusters) estimate.clusters.push_back(std::move(cluster));
  return estimate;
}

}  // namespace cvo
