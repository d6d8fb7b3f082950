// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/runner/score_run.h"

#include <optional>
#include <string>

#include "experiments/metrics/camera_metrics.h"

namespace cvo {
namespace {

std::vector<Metric> Score(const Sequence& sequence, const RunResult& run, bool causal) {
  std::vector<std::optional<RigidTransform>> estimate;
  for (const FrameRecord& frame : run.frames) {
    const bool skipped = frame.report.status == FrameStatus::kSkipped;
    const RigidTransform& pose =
        causal ? frame.report.world_from_camera : frame.refined_world_from_camera;
    estimate.push_back(skipped ? std::nullopt : std::optional(pose));
  }
  return EvaluateCamera(sequence.groundtruth_world_from_camera, estimate, sequence.groundtruth);
}

}  // namespace

RunScores ScoreRun(const Sequence& sequence, const RunResult& run) {
  if (run.status == RunStatus::kFailed) return {};
  RunScores scores{Score(sequence, run, false), Score(sequence, run, true)};
  const std::string prefix = "camera_";
  for (Metric& metric : scores.causal) {
    if (metric.name.starts_with(prefix)) metric.name.insert(prefix.size(), "causal_");
  }
  return scores;
}

}  // namespace cvo
