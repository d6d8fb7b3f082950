// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/runner/run_sequence.h"

#include <malloc.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/base/error.h"
#include "core/base/stage_times.h"
#include "core/base/task_pool.h"
#include "core/files/sha256.h"
#include "core/files/spool.h"
#include "core/interface/odometry.h"
#include "experiments/cache/content_hash.h"
#include "experiments/record/landmark_table.h"
#include "experiments/runner/frame_source.h"

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
void KeepTimes(const StageTimes& times_s, std::size_t all_frames, RunResult& result) {
  for (const auto& [stage, time_s] : times_s) {
    const auto [of_frames, added] = result.times_s.try_emplace(stage);
    // Allocated at once: a vector that grows in steps leaves holes between short-lived blocks.
    if (added) of_frames->second.reserve(all_frames);
  }
  for (auto& [stage, of_frames] : result.times_s) {
    of_frames.resize(result.frames.size(), std::numeric_limits<float>::quiet_NaN());
    const auto time_s = times_s.find(stage);
    if (time_s != times_s.end()) of_frames.back() = static_cast<float>(time_s->second);
  }
}

// Returns free memory to the system. Every frame leaves tens of megabytes free between blocks that
// stay, and not always in the same places, so that the memory in use would vary by as much.
void ReturnFreeMemory(std::size_t frames) {
  constexpr std::size_t kEvery_frames = 20;
  if (frames % kEvery_frames == 0) ::malloc_trim(0);
}

// The hashes of the images so far. In memory they would take a third of what is kept of a frame.
class HashLog {
 public:
  explicit HashLog(const std::filesystem::path& folder) : spool_(folder) {}

  std::size_t size() const { return spool_.size() / (2 * kHashBytes); }
  void Append(const ImageHashes& hashes) {
    for (std::string hash : {hashes.left, hashes.right}) {
      hash.resize(kHashBytes, ' ');  // the hash of an unreadable file is empty
      spool_.Append(hash);
    }
  }
  ImageHashes operator[](std::size_t frame) const { return {Read(2 * frame), Read(2 * frame + 1)}; }

 private:
  std::string Read(std::size_t image) const {
    std::string hash = spool_.Read(kHashBytes * image, kHashBytes);
    return hash.starts_with(' ') ? "" : hash;
  }

  Spool spool_;
};

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
  std::vector<LandmarkReport>& landmarks = record.report.landmarks;
  if (sink) sink(LandmarkRows(record.frame, given, landmarks, feature_truth));
  record.landmarks = Observe(landmarks, feature_truth);
  landmarks = std::vector<LandmarkReport>();  // frees its memory, which "= {}" does not
}

// Takes the final poses from the estimator. A failed run keeps its camera poses as they are, and no
// trajectories of clusters.
void Refine(const Odometry& odometry, RunResult& result) {
  if (result.status == RunStatus::kFailed) {
    result.clusters = PoseLog();
    return;
  }
  result.frames.Refine(odometry.Trajectory());
  result.clusters.Add(odometry.ClusterTrajectories());
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

// Returns the identity of the input, which does not depend on how far the run got.
std::string ContentOf(const RunRequest& request, const HashLog& hashes) {
  return ContentHash(request.sequence, [&](std::size_t i) {
    if (i < hashes.size()) return hashes[i];
    return request.images.empty() ? HashPair(request.sequence.images[i]) : request.images[i];
  });
}

}  // namespace

std::optional<RunResult> RunSequence(const RunRequest& request, BodyTruthReader* truth,
                                     const LandmarkSink& landmarks,
                                     const std::filesystem::path& spool_folder) {
  const Sequence& sequence = request.sequence;
  Require(request.images.empty() || request.images.size() == sequence.images.size(),
          "RunSequence: the hashes of all frames, or of none");
  const std::vector<std::vector<ObjectBox>> boxes = DetectionsByFrame(sequence);
  TruthOfFrame beside{truth, Oracle(sequence, request.oracle, truth)};
  const auto run_start = std::chrono::steady_clock::now();
  TaskPool pool(request.threads);
  std::unique_ptr<Odometry> odometry =
      request.variant.make({sequence.camera, request.options, request.seed}, pool);
  std::unique_ptr<FrameSource> source =
      OpenFrames({sequence, request.options, request.images, request.cache}, pool);

  RunResult result;
  result.frames = FrameLog(spool_folder);
  result.clusters = PoseLog(spool_folder);
  HashLog hashes(spool_folder);
  for (std::size_t i = 0; i < sequence.images.size(); ++i) {
    const auto frame_start = std::chrono::steady_clock::now();
    PreparedFrame prepared = source->Next();
    prepared.times_s["wait_for_features"] = SecondsSince(frame_start);
    if (request.strict) RefuseProblems(sequence, prepared);
    hashes.Append(prepared.hashes);
    AddDetections(request, boxes[i], prepared, result.detections);
    const auto feature_truth = AddTruth(request, static_cast<int>(i), beside, prepared);
    result.wall_s -= beside.seconds;
    std::optional<FrameRecord> record = Estimate(request, *odometry, prepared, result);
    if (!record) break;
    GiveLandmarks(prepared.frame, feature_truth, landmarks, *record);
    result.frames.Append(*record);
    result.clusters.Add(odometry->TakeSettledPoses());
    prepared.times_s["frame"] = SecondsSince(frame_start) - beside.seconds;
    KeepTimes(prepared.times_s, sequence.images.size(), result);
    ReturnFreeMemory(i + 1);
    request.progress(i + 1);
    if (request.stop()) return std::nullopt;
  }
  result.wall_s += SecondsSince(run_start);
  Refine(*odometry, result);
  JudgeStatus(result);
  if (result.status != RunStatus::kFailed) source->Finish();
  // Frees the memory of both for what follows.
  source.reset();
  odometry.reset();
  result.content = ContentOf(request, hashes);
  return result;
}

}  // namespace cvo
