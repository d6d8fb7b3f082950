// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/runner/run_job.h"

#include <cmath>
#include <memory>
#include <utility>

#include "core/base/error.h"
#include "core/base/task_pool.h"
#include "core/files/json/options_json.h"
#include "experiments/datasets/body_truth.h"
#include "experiments/datasets/sequence.h"
#include "experiments/runner/identity.h"
#include "experiments/runner/run_files.h"

namespace cvo {

namespace {

// Warns of a run whose estimates take much memory; all of them are held until its end.
void WarnOfMemory(const RunResult& run, std::vector<std::string>& warnings) {
  constexpr double kMuch_bytes = 2e9;
  std::size_t bytes = run.frames.size() * sizeof(FrameRecord);
  for (const FrameRecord& frame : run.frames) {
    bytes += frame.report.clusters.size() * (sizeof(ClusterReport) + sizeof(ClusterPose)) +
             frame.detections.size() * sizeof(Detection) +
             frame.landmarks.size() * sizeof(LandmarkObservation);
  }
  const double held = static_cast<double>(bytes);
  if (held <= kMuch_bytes) return;
  warnings.push_back(StrCat("the estimates of ", run.frames.size(), " frames took ",
                            std::round(held / 1e8) / 10.0,
                            " GB of memory: parts of the sequence (--frames) need less"));
}

std::vector<Metric> AllMetrics(const RunScores& scores) {
  std::vector<Metric> all = scores.refined;
  all.insert(all.end(), scores.causal.begin(), scores.causal.end());
  all.insert(all.end(), scores.clustering.begin(), scores.clustering.end());
  all.insert(all.end(), scores.boxes.begin(), scores.boxes.end());
  all.insert(all.end(), scores.calibration.begin(), scores.calibration.end());
  return all;
}

std::optional<reports::RunBodies> BodiesOf(const RunScores& scores) {
  if (scores.refined_bodies.empty()) return std::nullopt;
  return reports::RunBodies{{scores.refined_bodies.begin(), scores.refined_bodies.end()},
                            {scores.causal_bodies.begin(), scores.causal_bodies.end()}};
}

Json GivenOf(const RunRequest& request) {
  return Given(request.sequence, request.classes, request.oracle);
}

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

Json ResolvedOptions(const RunRequest& request) {
  Options options = request.options;
  return OptionsToJson(OptionLeaves(options));
}

}  // namespace

Json Given(const Sequence& sequence, const std::vector<std::string>& classes,
           const OracleSwitches& oracle) {
  return GivenToJson(sequence.detections.empty() ? std::vector<std::string>() : classes,
                     oracle.Names());
}

std::string IdentifyJob(const RunRequest& request) {
  const std::vector<ImageHashes> images =
      request.images.empty() ? HashImages(request.sequence) : request.images;
  return JobIdentity({ThisBuild().identity, std::string(request.variant.name),
                      ResolvedOptions(request), ContentHash(request.sequence, images),
                      DetectionsHash(request.sequence), GivenOf(request), request.seed});
}

std::optional<JobOutcome> RunJob(const RunRequest& request, const std::filesystem::path& folder) {
  const BuildIdentity build = ThisBuild();
  const std::unique_ptr<BodyTruthReader> truth = ReadBodyTruth(request.sequence);
  const std::optional<Vector6d> right_field_px = TrueRightField(request.sequence);
  std::optional<StagedFile> landmarks;
  LandmarkSink sink;
  if (request.landmarks) {
    landmarks.emplace(BeginLandmarks(folder));
    sink = [&landmarks](const std::string& rows) { landmarks->Append(rows); };
  }
  std::optional<RunResult> run = RunSequence(request, truth.get(), sink);
  if (!run) return std::nullopt;

  const ObjectTruth* bodies = truth ? &truth->objects() : nullptr;
  JobOutcome outcome{std::move(*run), {}, ThisProcess()};
  outcome.warnings = FindImplausible(request.sequence, bodies);
  outcome.scores = ScoreRun(request.sequence, outcome.run, {bodies, right_field_px});
  const RunRecord record{.sequence = request.sequence,
                         .build = build,
                         .variant = std::string(request.variant.name),
                         .options = ResolvedOptions(request),
                         .given = GivenOf(request),
                         .seed = request.seed,
                         .metrics = AllMetrics(outcome.scores),
                         .bodies = BodiesOf(outcome.scores),
                         .run = outcome.run,
                         .truth = {.camera = &request.sequence.groundtruth_world_from_camera,
                                   .objects = bodies,
                                   .truth_from_estimate = outcome.scores.truth_from_estimate,
                                   .bodies = &outcome.scores.refined_bodies},
                         .warnings = outcome.warnings};
  outcome.context.job = RecordedJob(record);
  outcome.context.threads = request.threads;
  outcome.context.paths = PathsOf(request.sequence, folder);
  WriteRunFiles(folder, record, outcome.context, std::move(landmarks));
  WarnOfMemory(outcome.run, outcome.warnings);  // no part of the result
  return outcome;
}

JobCache::JobCache(const std::filesystem::path& cache_folder, std::uint64_t limit_bytes,
                   const FileHashHooks& hooks)
    : folder_(cache_folder),
      hooks_(hooks),
      hashes_(cache_folder / "hashes"),
      front_end_(cache_folder / "frontend", limit_bytes, hooks.notice) {}

std::vector<std::string> JobCache::HashesOf(const std::vector<std::filesystem::path>& files,
                                            int threads) const {
  TaskPool pool(threads);
  return FindFileHashes(files, hashes_, pool, hooks_);
}

std::vector<ImageHashes> JobCache::ImagesOf(const Sequence& sequence, int threads) const {
  TaskPool pool(threads);
  return FindImageHashes(sequence, hashes_, pool, hooks_);
}

void JobCache::Serve(RunRequest& request) const {
  request.images = ImagesOf(request.sequence, request.threads);
  request.cache = &front_end_;
}

}  // namespace cvo
