// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/files/json/json.h"
#include "experiments/datasets/body_truth.h"
#include "experiments/datasets/sequence.h"
#include "experiments/metrics/objects/object_matching.h"
#include "experiments/metrics/objects/object_scores.h"
#include "experiments/metrics/pose_errors.h"
#include "experiments/runner/front_end_cache.h"
#include "experiments/runner/identity.h"
#include "experiments/runner/run_result.h"

namespace cvo {

// Returns the estimator's options as nested JSON.
Json ResolvedOptions(Options options);

// Returns GivenToJson of a job. Classes only count if there are boxes.
Json Given(const Sequence& sequence, const std::vector<std::string>& classes,
           const OracleSwitches& oracle);

// Returns the JobIdentity of what RunSequence would do, from the bytes of the sequence's files;
// nothing is decoded. Does not read images whose hashes are in the request.
std::string IdentifyJob(const RunRequest& request);

// An estimated frame with all that its record does not keep.
struct EstimatedFrame {
  const StereoFrame& given;
  const std::vector<LandmarkTruth>& feature_truth;  // empty without ground truth
  const FrameRecord& record;                        // its report has landmarks and CRF
};
using FrameSink = std::function<void(const EstimatedFrame&)>;

// Counts landmarks that are alike: a frame has a thousand landmarks of a dozen kinds. Empty without
// ground truth.
std::vector<LandmarkObservation> CountLandmarks(const std::vector<LandmarkReport>& landmarks,
                                                const std::vector<LandmarkTruth>& feature_truth);

// Runs the variant over every frame of the sequence. Returns nothing if `stop` ended the run. An
// Error of the estimator itself is a result too (status failed, with the frames so far); all others
// are thrown. With `truth`, the ground truth of landmarks is recorded; the time for that does not
// count as the run's.
[[nodiscard]] std::optional<RunResult> RunSequence(const RunRequest& request,
                                                   BodyTruthReader* truth = nullptr,
                                                   const FrameSink& sink = {});

// Scores a run. `objects`: the ground truth of the bodies; null: there is none.
RunScores ScoreRun(const RunResult& run, const ObjectTruth* objects = nullptr);

// The metrics of camera and bodies of an estimate, whichever system made it.
struct PoseScores {
  std::vector<Metric> metrics;  // camera_*, object_*
  std::vector<BodyScore> bodies;
};
PoseScores ScorePoses(const Sequence& sequence, const ObjectTruth* objects,
                      const ObjectEstimate& estimate);

// Returns what a run states about the bodies, with poses as first estimated (causal) or as last
// estimated (refined). Skipped frames have no camera pose. There is one element per frame of the
// run.
ObjectEstimate ObjectEstimateOf(const RunResult& run, reports::PoseTime time);

// Runs the job, scores it and writes its files to an existing folder (WriteRunFiles). Returns
// nothing if the request's `stop` ended the run; no file is written then.
[[nodiscard]] std::optional<RunResult> RunJob(const RunRequest& request,
                                              const std::filesystem::path& folder);

}  // namespace cvo
