// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/runner/run_sequence.h"

#include <algorithm>
#include <chrono>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/base/error.h"
#include "core/base/stage_times.h"
#include "core/base/task_pool.h"
#include "core/interface/frame.h"
#include "experiments/runner/frame_source.h"
#include "experiments/runner/identity.h"
#include "experiments/runner/run_tables.h"

namespace cvo {
namespace {

double SecondsSince(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void RefuseProblems(const Sequence& sequence, const PreparedFrame& prepared) {
  if (prepared.problems.empty()) return;
  const ImageProblem& problem = prepared.problems.front();
  throw Error(
      StrCat((sequence.folder / problem.image).lexically_normal().string(), ": ", problem.reason));
}

// Ground truth of the bodies, kept separate from the estimator.
struct TruthOfFrame {
  BodyTruthReader* reader = nullptr;  // may be null
  Oracle oracle;
  double seconds = 0.0;  // spent here on the last frame
};

// Adds the boxes of the frame to the estimator's input.
void AddDetections(const RunRequest& request, const std::vector<ObjectBox>& boxes,
                   PreparedFrame& prepared, DetectionCounts& counts) {
  if (!prepared.problems.empty()) {
    counts.skipped += static_cast<int>(boxes.size());
    return;
  }
  StereoFrame& frame = prepared.frame;
  frame.detections =
      DetectionsOfFrame(boxes, {request.sequence.camera, request.sequence.detections_offset_m},
                        frame.features, request.classes, counts);
}

// Returns the ground truth at the frame's features, and adds to the frame what the oracle gives.
// Empty without ground truth.
std::vector<LandmarkTruth> AddTruth(const RunRequest& request, int index, TruthOfFrame& truth,
                                    PreparedFrame& prepared) {
  const auto start = std::chrono::steady_clock::now();
  std::vector<LandmarkTruth> feature_truth;
  if (prepared.problems.empty()) {
    if (truth.reader != nullptr) {
      feature_truth =
          TruthOfFeatures(index, prepared.frame.features, request.sequence.camera, *truth.reader);
    }
    truth.oracle.Give(index, feature_truth, prepared.frame);
  }
  truth.seconds = SecondsSince(start);
  return feature_truth;
}

// Counts landmarks that are alike: a frame has a thousand landmarks of a dozen kinds.
std::vector<LandmarkObservation> Observe(const std::vector<LandmarkReport>& landmarks,
                                         const std::vector<LandmarkTruth>& feature_truth) {
  std::vector<LandmarkObservation> kinds;
  if (feature_truth.empty()) return kinds;
  for (const LandmarkReport& landmark : landmarks) {
    const auto cluster = static_cast<std::int32_t>(landmark.cluster.value);
    const LandmarkTruth& truth = feature_truth.at(static_cast<std::size_t>(landmark.feature));
    const auto kind =
        std::find_if(kinds.begin(), kinds.end(), [&](const LandmarkObservation& other) {
          return other.cluster == cluster && other.truth == truth;
        });
    if (kind == kinds.end()) {
      kinds.push_back({cluster, truth, 1});
    } else {
      ++kind->count;
    }
  }
  return kinds;
}

// Appends the stage times of the last frame.
void KeepTimes(const StageTimes& times_s, RunResult& result) {
  for (const auto& [stage, time_s] : times_s) result.times_s.try_emplace(stage);
  for (auto& [stage, of_frames] : result.times_s) {
    of_frames.resize(result.frames.size(), std::numeric_limits<float>::quiet_NaN());
    const auto time_s = times_s.find(stage);
    if (time_s != times_s.end()) of_frames.back() = static_cast<float>(time_s->second);
  }
}

// Processes one frame with the estimator. If that throws Error, marks the result as failed and
// returns nothing.
std::optional<FrameRecord> Estimate(const RunRequest& request, Odometry& odometry,
                                    PreparedFrame& prepared, RunResult& result) {
  FrameRecord record;
  record.frame = request.sequence.first_frame + static_cast<int>(result.frames.size());
  record.timestamp_ns = prepared.frame.timestamp_ns;
  record.problems = std::move(prepared.problems);
  try {
    const ScopedStage stage(prepared.times_s, "estimate");
    record.report = record.problems.empty() ? odometry.Process(prepared.frame, prepared.times_s)
                                            : odometry.Skip(record.timestamp_ns);
  } catch (const Error& error) {
    result.status = RunStatus::kFailed;
    result.message = StrCat("frame ", record.frame, ": ", error.what());
    return std::nullopt;
  }
  record.refined_world_from_camera = record.report.world_from_camera;
  record.detections = std::move(prepared.frame.detections);
  return record;
}

// Passes the landmarks of a frame to `sink` and keeps only their counts.
void GiveLandmarks(const StereoFrame& given, const std::vector<LandmarkTruth>& feature_truth,
                   const LandmarkSink& sink, FrameRecord& record) {
  const std::vector<LandmarkReport> landmarks = std::exchange(record.report.landmarks, {});
  if (sink) sink(LandmarkRows(record.frame, given, landmarks, feature_truth));
  record.landmarks = Observe(landmarks, feature_truth);
}

// Takes the final poses from the estimator. A failed run keeps its camera poses as they are, and no
// trajectories of clusters.
void Refine(const Odometry& odometry, RunResult& result) {
  if (result.status == RunStatus::kFailed) return;
  const std::vector<RigidTransform> poses = odometry.Trajectory();
  Require(poses.size() == result.frames.size(), "Odometry: one pose per frame");
  for (std::size_t i = 0; i < poses.size(); ++i) {
    result.frames[i].refined_world_from_camera = poses[i];
  }
  result.clusters = odometry.ClusterTrajectories();
}

void JudgeStatus(RunResult& result) {
  if (result.status == RunStatus::kFailed) return;
  int lost = 0;
  int first_lost = 0;
  for (const FrameRecord& frame : result.frames) {
    if (frame.report.status != FrameStatus::kLost) continue;
    if (lost++ == 0) first_lost = frame.frame;
  }
  if (lost == 0) return;
  result.status = RunStatus::kLost;
  result.message =
      StrCat(lost, " of ", result.frames.size(), " frames lost, the first is frame ", first_lost);
}

// Returns the identity of the input, which does not depend on how far the run got. `images` has the
// hashes of the frames that were read.
std::string ContentOf(const RunRequest& request, std::vector<ImageHashes> images) {
  for (std::size_t i = images.size(); i < request.sequence.images.size(); ++i) {
    images.push_back(request.images.empty() ? HashPair(request.sequence.images[i])
                                            : request.images[i]);
  }
  return ContentHash(request.sequence, images);
}

}  // namespace

std::optional<RunResult> RunSequence(const RunRequest& request, BodyTruthReader* truth,
                                     const LandmarkSink& landmarks) {
  const Sequence& sequence = request.sequence;
  Require(request.images.empty() || request.images.size() == sequence.images.size(),
          "RunSequence: the hashes of all frames, or of none");
  const std::vector<std::vector<ObjectBox>> boxes = DetectionsByFrame(sequence);
  TruthOfFrame beside{truth, Oracle(sequence, request.oracle, truth)};
  const auto run_start = std::chrono::steady_clock::now();
  TaskPool pool(request.threads);
  const std::unique_ptr<Odometry> odometry =
      request.variant.make({sequence.camera, request.options, request.seed}, pool);
  const std::unique_ptr<FrameSource> source =
      OpenFrames({sequence, request.options, request.images, request.cache}, pool);

  RunResult result;
  std::vector<ImageHashes> hashes;
  for (std::size_t i = 0; i < sequence.images.size(); ++i) {
    const auto frame_start = std::chrono::steady_clock::now();
    PreparedFrame prepared = source->Next();
    prepared.times_s["wait_for_features"] = SecondsSince(frame_start);
    if (request.strict) RefuseProblems(sequence, prepared);
    hashes.push_back(prepared.hashes);
    AddDetections(request, boxes[i], prepared, result.detections);
    const auto feature_truth = AddTruth(request, static_cast<int>(i), beside, prepared);
    result.wall_s -= beside.seconds;
    std::optional<FrameRecord> record = Estimate(request, *odometry, prepared, result);
    if (!record) break;
    GiveLandmarks(prepared.frame, feature_truth, landmarks, *record);
    result.frames.push_back(std::move(*record));
    prepared.times_s["frame"] = SecondsSince(frame_start) - beside.seconds;
    KeepTimes(prepared.times_s, result);
    request.progress(i + 1);
    if (request.stop()) return std::nullopt;
  }
  result.wall_s += SecondsSince(run_start);
  Refine(*odometry, result);
  JudgeStatus(result);
  if (result.status != RunStatus::kFailed) source->Finish();
  result.content = ContentOf(request, std::move(hashes));
  return result;
}

}  // namespace cvo
