// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/runner/run_job.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/base/error.h"
#include "core/base/stage_times.h"
#include "core/base/task_pool.h"
#include "core/files/json/options_json.h"
#include "core/files/text/number.h"
#include "core/interface/frame.h"
#include "experiments/datasets/body_truth.h"
#include "experiments/datasets/plausibility.h"
#include "experiments/datasets/sequence.h"
#include "experiments/metrics/camera_metrics.h"
#include "experiments/runner/frame_source.h"
#include "experiments/runner/identity.h"
#include "experiments/runner/run_files.h"

namespace cvo {

namespace {

double SecondsSince(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// The record of a frame before it is estimated.
FrameRecord RecordOf(const RunRequest& request, std::size_t index, const PreparedFrame& prepared) {
  const Sequence& sequence = request.sequence;
  FrameRecord record;
  record.frame = sequence.first_frame + static_cast<int>(index);
  record.timestamp_ns = sequence.timestamps_ns[index];
  const StereoPaths& paths = sequence.images[index];
  for (const SideProblem& problem : prepared.problems) {
    const std::filesystem::path& image = problem.side == 0 ? paths.left : paths.right;
    record.problems.push_back(
        {image.lexically_relative(sequence.folder).generic_string(), problem.reason});
  }
  return record;
}

// Ground truth of the bodies, kept separate from the estimator.
struct TruthOfFrame {
  BodyTruthReader* reader = nullptr;  // may be null
  Oracle oracle;
  double seconds = 0.0;  // spent here on the last frame
};

// Adds the boxes of the frame to the estimator's input.
void AddDetections(const RunRequest& request, const std::vector<ObjectBox>& boxes,
                   StereoFrame& frame, DetectionCounts& counts) {
  frame.detections =
      DetectionsOfFrame(boxes, {request.sequence.camera, request.sequence.detections_offset_m},
                        frame.features, request.classes, counts);
}

// Returns the ground truth at the frame's features, and adds to the frame what the oracle gives.
// Empty without ground truth.
std::vector<LandmarkTruth> AddTruth(const RunRequest& request, int index, TruthOfFrame& truth,
                                    StereoFrame& frame) {
  const auto start = std::chrono::steady_clock::now();
  std::vector<LandmarkTruth> feature_truth;
  if (truth.reader != nullptr) {
    feature_truth = TruthOfFeatures(index, frame.features, request.sequence.camera, *truth.reader);
  }
  truth.oracle.Give(index, feature_truth, frame);
  truth.seconds = SecondsSince(start);
  return feature_truth;
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

// Processes one frame with the estimator. Throws what it throws.
void Estimate(const StereoFrame& frame, Odometry& odometry, StageTimes& times_s,
              FrameRecord& record) {
  const ScopedStage stage(times_s, "estimate");
  record.report = record.problems.empty() ? odometry.Process(frame, times_s)
                                          : odometry.Skip(record.timestamp_ns);
  record.refined_world_from_camera = record.report.world_from_camera;
  record.detections = frame.detections;
}

// Passes a frame to `sink`, then keeps only the counts of its landmarks.
void GiveFrame(const StereoFrame& given, const std::vector<LandmarkTruth>& feature_truth,
               const FrameSink& sink, FrameRecord& record) {
  if (sink) sink({given, feature_truth, record});
  record.landmarks = CountLandmarks(record.report.landmarks, feature_truth);
  record.report.landmarks = std::vector<LandmarkReport>();  // `= {}` would keep its memory
  record.report.crf = {};
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

// Hashes of all images, from their files unless the request has them.
std::vector<ImageHashes> ImagesOf(const RunRequest& request) {
  return request.images.empty() ? HashImages(request.sequence) : request.images;
}

std::string JobOf(const RunRequest& request, const std::string& content) {
  return reports::JobIdentity(
      {ThisBuild().identity, std::string(request.variant.name), ResolvedOptions(request.options),
       content, DetectionsHash(request.sequence),
       Given(request.sequence, request.classes, request.oracle), request.seed});
}

}  // namespace

std::vector<LandmarkObservation> CountLandmarks(const std::vector<LandmarkReport>& landmarks,
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

Json ResolvedOptions(Options options) { return OptionsToJson(OptionLeaves(options)); }

Json Given(const Sequence& sequence, const std::vector<std::string>& classes,
           const OracleSwitches& oracle) {
  return GivenToJson(sequence.detections.empty() ? std::vector<std::string>() : classes,
                     oracle.Names());
}

std::string IdentifyJob(const RunRequest& request) {
  return JobOf(request, ContentHash(request.sequence, ImagesOf(request)));
}

std::optional<RunResult> RunSequence(const RunRequest& request, BodyTruthReader* truth,
                                     const FrameSink& sink) {
  const Sequence& sequence = request.sequence;
  Require(request.images.empty() || request.images.size() == sequence.images.size(),
          "RunSequence: the hashes of all frames, or of none");
  const std::vector<std::vector<ObjectBox>> boxes = DetectionsByFrame(sequence);
  TruthOfFrame beside{truth, Oracle(sequence, request.oracle, truth)};
  const auto run_start = std::chrono::steady_clock::now();
  const double cpu_start_s = CpuSeconds();
  TaskPool pool(request.threads);
  const std::unique_ptr<Odometry> odometry =
      request.variant.make({sequence.camera, request.options, request.seed}, pool);
  FrameSource source({sequence, request.options, request.images, request.cache}, pool);

  RunResult result{request};
  std::vector<ImageHashes> hashes;
  for (std::size_t i = 0; i < sequence.images.size(); ++i) {
    const auto frame_start = std::chrono::steady_clock::now();
    PreparedFrame prepared = source.Next();
    prepared.times_s["wait_for_features"] = SecondsSince(frame_start);
    hashes.push_back(prepared.hashes);
    FrameRecord record = RecordOf(request, i, prepared);
    StereoFrame frame{record.timestamp_ns, std::move(prepared.features), {}, {}};
    std::vector<LandmarkTruth> feature_truth;
    beside.seconds = 0.0;
    if (record.problems.empty()) {
      AddDetections(request, boxes[i], frame, result.detections);
      feature_truth = AddTruth(request, static_cast<int>(i), beside, frame);
    } else {
      result.detections.skipped += static_cast<int>(boxes[i].size());
    }
    result.wall_s -= beside.seconds;
    result.cpu_s -= beside.seconds;
    try {
      Estimate(frame, *odometry, prepared.times_s, record);
    } catch (const Error& error) {
      result.status = RunStatus::kFailed;
      result.message = StrCat("frame ", record.frame, ": ", error.what());
      break;
    }
    GiveFrame(frame, feature_truth, sink, record);
    result.frames.push_back(std::move(record));
    prepared.times_s["frame"] = SecondsSince(frame_start) - beside.seconds;
    KeepTimes(prepared.times_s, result);
    request.progress(i + 1);
    if (request.stop()) return std::nullopt;
  }
  result.wall_s += SecondsSince(run_start);
  result.cpu_s += CpuSeconds() - cpu_start_s;
  Refine(*odometry, result);
  JudgeStatus(result);
  if (result.status != RunStatus::kFailed) source.Finish();
  // The identity of what was read does not depend on how far the run got.
  if (hashes.size() < sequence.images.size()) hashes = ImagesOf(request);
  result.content = ContentHash(sequence, hashes);
  result.images_hash = ImagesHash(hashes);
  std::size_t repeated = 0;
  for (std::size_t i = 1; i < hashes.size(); ++i) {
    if (hashes[i].left == hashes[i - 1].left || hashes[i].right == hashes[i - 1].right) ++repeated;
  }
  const bool as_recorded = PerturbationToJson(sequence.perturbation).empty();
  result.warnings = FindImplausible(sequence, as_recorded ? repeated : 0, request.threads);
  result.job = JobOf(request, result.content);
  return result;
}

namespace {

// Returns the absolute path of a file. Levels of a scene and "labels" are not files and are
// returned unchanged.
std::optional<std::string> PathOf(const std::filesystem::path& source) {
  if (source.empty()) return std::nullopt;
  std::error_code ignored;
  const bool is_file = std::filesystem::exists(source, ignored);
  return is_file ? std::filesystem::absolute(source).string() : source.string();
}

reports::RunPaths PathsOf(const Sequence& sequence, const std::filesystem::path& output) {
  const BoxSources& boxes = sequence.box_sources;
  reports::RunPaths paths;
  paths.sequence = std::filesystem::absolute(sequence.folder).string();
  paths.output = std::filesystem::absolute(output).string();
  paths.labels = PathOf(boxes.labels);
  paths.detections = PathOf(boxes.detections);
  if (boxes.detections_camera >= 0) paths.detections_camera = boxes.detections_camera;
  if (boxes.min_score > BoxSources().min_score) paths.min_score = boxes.min_score;
  return paths;
}

// An error of position can hide that the camera ends up turned.
void WarnOfRotation(RunResult& run) {
  constexpr double kLimit_deg = 2.0;
  const Metric* error = FindMetric(run.scores.metrics, "camera_end_rotation");
  const double error_deg = error ? error->value * 180.0 / std::numbers::pi : 0.0;
  if (error_deg > kLimit_deg) {
    run.warnings.push_back(StrCat("the camera ends turned by ", FormatGeneral(error_deg, 3),
                                  " degrees against the truth; up to ", kLimit_deg, " are usual"));
  }
}

}  // namespace

std::optional<RunResult> RunJob(const RunRequest& request, const std::filesystem::path& folder) {
  const std::unique_ptr<BodyTruthReader> truth = ReadBodyTruth(request.sequence);
  const ObjectTruth* bodies = truth ? &truth->objects() : nullptr;
  std::optional<StagedFile> landmarks;
  FrameSink sink;
  if (request.landmarks) {
    landmarks.emplace(BeginLandmarks(folder));
    sink = [&landmarks](const EstimatedFrame& seen) {
      landmarks->Append(LandmarkRows(seen.record.frame, seen.given, seen.record.report.landmarks,
                                     seen.feature_truth));
    };
  }
  std::optional<RunResult> run = RunSequence(request, truth.get(), sink);
  if (!run) return std::nullopt;
  run->timing = ThisProcess();
  run->timing.job = run->job;
  run->timing.threads = request.threads;
  run->timing.paths = PathsOf(request.sequence, folder);
  run->scores = ScoreRun(*run, bodies);
  WarnOfRotation(*run);
  WriteRunFiles(folder, *run, bodies, std::move(landmarks));
  return run;
}

}  // namespace cvo
