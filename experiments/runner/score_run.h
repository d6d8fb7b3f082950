// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "experiments/datasets/sequence.h"
#include "experiments/metrics/objects/object_matching.h"
#include "experiments/metrics/objects/object_scores.h"
#include "experiments/metrics/pose_errors.h"
#include "experiments/runner/run_result.h"

namespace cvo {

// The metrics of a run against the sequence's ground truth. A skipped frame has no estimate; a lost
// frame counts with its predicted pose. Empty if there is no ground truth or the run failed.
struct RunScores {
  std::vector<Metric> refined;         // camera_*, object_*: poses as last estimated
  std::vector<Metric> causal;          // camera_causal_*, object_causal_*: poses as first estimated
  std::vector<Metric> clustering;      // moving_*, clustering_*: labels as first estimated
  std::vector<Metric> boxes;           // box_ap_*
  std::vector<Metric> calibration;     // calibration_*: of rendered scenes, after the last frame
  RigidTransform truth_from_estimate;  // between the worlds, from refined poses
  std::vector<BodyScore> refined_bodies;
  std::vector<BodyScore> causal_bodies;
};
// The ground truth of a sequence besides its camera's.
struct RunTruth {
  const ObjectTruth* objects = nullptr;    // null if there is none for its bodies
  std::optional<Vector6d> right_field_px;  // of the calibration: TrueRightField
};
RunScores ScoreRun(const Sequence& sequence, const RunResult& run, const RunTruth& truth = {});

// Returns what a run states about the bodies, with poses as first estimated (causal) or as last
// estimated (refined). Skipped frames have no camera pose. There is one element per frame of the
// run.
enum class PoseTime { kCausal, kRefined };
ObjectEstimate ObjectEstimateOf(const RunResult& run, PoseTime time);

}  // namespace cvo
