// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <utility>

#include "experiments/datasets/body_truth.h"
#include "experiments/metrics/boxes/average_precision.h"
#include "experiments/metrics/camera_metrics.h"
#include "experiments/metrics/objects/object_scores.h"
#include "experiments/runner/run_files.h"
#include "experiments/runner/run_job.h"
#include "experiments/runner/run_result.h"

namespace cvo {
namespace {

// Appends metrics of poses of that time.
void Append(std::vector<Metric> from, reports::PoseTime poses, const Sequence& sequence,
            std::vector<Metric>& to) {
  StatePoses(poses, sequence.camera.right_shift_px, from);
  std::move(from.begin(), from.end(), std::back_inserter(to));
}

// Renames metrics to their causal form, for example "camera_ate" to "camera_causal_ate". Removes
// those that have no such form.
void NameCausal(std::vector<Metric>& metrics) {
  std::erase_if(metrics, [](const Metric& metric) {
    const reports::MetricId id = reports::FindForm(metric.name).value().id;
    return id == reports::MetricId::kCameraTruthGap || reports::MaxDriftIndex(id).has_value();
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

// An estimate of the run that is matched to bodies by landmarks where the truth tells pixels.
ObjectEstimate MatchedEstimate(const RunResult& run, const ObjectTruth* objects,
                               reports::PoseTime time) {
  ObjectEstimate estimate = ObjectEstimateOf(run, time);
  if (objects == nullptr || !objects->tells_pixels) estimate.match_by = MatchBy::kNearness;
  return estimate;
}

void ScoreRefined(const RunResult& run, const ObjectTruth* objects, RunScores& scores) {
  const ObjectEstimate refined = MatchedEstimate(run, objects, reports::PoseTime::kRefined);
  PoseScores poses = ScorePoses(run.sequence, objects, refined);
  Append(std::move(poses.metrics), reports::PoseTime::kRefined, run.sequence, scores.metrics);
  scores.refined_bodies = std::move(poses.bodies);
  scores.truth_from_estimate =
      AlignByCamera(run.sequence.groundtruth_world_from_camera, refined.world_from_camera);
}

void ScoreCausal(const RunResult& run, const ObjectTruth* objects, RunScores& scores) {
  const ObjectEstimate causal = MatchedEstimate(run, objects, reports::PoseTime::kCausal);
  PoseScores poses = ScorePoses(run.sequence, objects, causal);
  NameCausal(poses.metrics);
  Append(std::move(poses.metrics), reports::PoseTime::kCausal, run.sequence, scores.metrics);
  scores.causal_bodies = std::move(poses.bodies);
  if (objects == nullptr || !objects->tells_pixels) return;
  Append(ClusteringMetrics(*objects, causal, MatchObjects(*objects, causal)),
         reports::PoseTime::kCausal, run.sequence, scores.metrics);
}

}  // namespace

PoseScores ScorePoses(const Sequence& sequence, const ObjectTruth* objects,
                      const ObjectEstimate& estimate) {
  PoseScores scores{
      EvaluateCamera(sequence.groundtruth_world_from_camera, estimate.world_from_camera,
                     EnumOf<reports::TruthSource>(sequence.groundtruth)),
      {}};
  if (!sequence.velocity_world_from_camera.empty()) {
    std::vector<Metric> of_truths =
        CompareTruths(sequence.groundtruth_world_from_camera, sequence.velocity_world_from_camera,
                      estimate.world_from_camera);
    std::move(of_truths.begin(), of_truths.end(), std::back_inserter(scores.metrics));
  }
  if (objects == nullptr) return scores;
  ObjectScores of_objects = ScoreObjects(*objects, estimate);
  std::vector<Metric> metrics = ObjectMetrics(*objects, of_objects);
  std::move(metrics.begin(), metrics.end(), std::back_inserter(scores.metrics));
  scores.bodies = std::move(of_objects.bodies);
  return scores;
}

RunScores ScoreRun(const RunResult& run, const ObjectTruth* objects) {
  if (run.status == RunStatus::kFailed) return {};
  const Sequence& sequence = run.sequence;
  RunScores scores;
  // One after the other, as each estimate holds all poses of a run.
  ScoreRefined(run, objects, scores);
  ScoreCausal(run, objects, scores);
  if (TellsBoxes(sequence)) {
    std::vector<ObjectBox> boxes;
    ForEachTrackBox(run, [&boxes](const ObjectBox& box) { boxes.push_back(box); });
    Append(BoxMetrics(sequence, boxes), reports::PoseTime::kRefined, sequence, scores.metrics);
  }
  const std::optional<CalibrationReport> found = LastCalibration(run);
  const std::optional<Vector6d> truth = TrueRightField(sequence);
  if (found && truth) {
    Append(EvaluateCalibration(*truth, *found), reports::PoseTime::kCausal, sequence,
           scores.metrics);
  }
  return scores;
}

ObjectEstimate ObjectEstimateOf(const RunResult& run, reports::PoseTime time) {
  ObjectEstimate estimate;
  int first_frame = 0;
  for (const FrameRecord& frame : run.frames) {
    if (estimate.landmarks.empty()) first_frame = frame.frame;
    const RigidTransform& pose = time == reports::PoseTime::kCausal
                                     ? frame.report.world_from_camera
                                     : frame.refined_world_from_camera;
    const bool skipped = frame.report.status == FrameStatus::kSkipped;
    estimate.world_from_camera.push_back(skipped ? std::nullopt : std::optional(pose));
    estimate.landmarks.push_back(frame.landmarks);
  }
  std::map<ClusterId, ClusterEstimate> clusters;
  ForEachLiveCluster(run, [&](const LiveCluster& row) {
    const ClusterReport* report = time == reports::PoseTime::kCausal ? row.causal : &row.Last();
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
