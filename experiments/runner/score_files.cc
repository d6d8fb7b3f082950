// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/runner/score_files.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "core/base/error.h"
#include "core/files/atomic_file.h"
#include "core/files/sha256.h"
#include "core/files/text_file.h"
#include "experiments/datasets/body_truth.h"
#include "experiments/metrics/camera_metrics.h"
#include "experiments/metrics/objects/object_scores.h"
#include "experiments/record/build_identity.h"
#include "experiments/record/system_result.h"

namespace cvo {
namespace {

namespace fs = std::filesystem;

// Hashes a file, or the names and bytes of the trajectories in a folder.
std::string HashObjects(const fs::path& objects) {
  if (objects.empty()) return "";
  if (!fs::is_directory(objects)) return Sha256Hex(ReadFileBytes(objects));
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(objects)) {
    if (entry.path().extension() == ".tum") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  Json hashes = Json::array();
  for (const fs::path& file : files) {
    hashes.push_back({file.filename().string(), Sha256Hex(ReadFileBytes(file))});
  }
  return Sha256Hex(DumpJson(hashes));
}

SystemHashes HashesOf(const SystemFiles& files) {
  return {Sha256Hex(ReadFileBytes(files.camera)), HashObjects(files.objects)};
}

void Score(const SystemRequest& request, const ObjectEstimate& estimate, const ObjectTruth* truth,
           SystemOutcome& outcome) {
  const Sequence& sequence = request.sequence;
  outcome.metrics =
      EvaluateCamera(sequence.groundtruth_world_from_camera, estimate.world_from_camera,
                     EnumOf<reports::TruthSource>(sequence.groundtruth));
  if (truth != nullptr) {
    ObjectScores scores = ScoreObjects(*truth, estimate);
    for (Metric& metric : ObjectMetrics(*truth, scores)) {
      outcome.metrics.push_back(std::move(metric));
    }
    outcome.bodies = std::move(scores.bodies);
  }
  StatePoses(reports::PoseTime::kRefined, request.right_shift_px, outcome.metrics);
}

std::optional<reports::RunBodies> BodiesOf(const std::vector<BodyScore>& bodies) {
  if (bodies.empty()) return std::nullopt;
  return reports::RunBodies{{bodies.begin(), bodies.end()}, {}};
}

}  // namespace

std::string IdentifySystem(const SystemRequest& request) {
  return SystemJob(ThisBuild(), request.files.name, HashesOf(request.files), request.content,
                   request.seed);
}

SystemOutcome ScoreSystem(const SystemRequest& request) {
  const SystemEstimate system = ReadSystem(request.sequence, request.files);
  const std::unique_ptr<BodyTruthReader> reader =
      request.files.objects.empty() ? nullptr : ReadBodyTruth(request.sequence);
  const ObjectTruth* truth = reader ? &reader->objects() : nullptr;
  SystemOutcome outcome;
  Score(request, system.objects, truth, outcome);
  const SystemHashes hashes = HashesOf(request.files);
  outcome.job = SystemJob(ThisBuild(), request.files.name, hashes, request.content, request.seed);
  outcome.frames = static_cast<int>(request.sequence.images.size());
  outcome.frames_without_camera = system.frames_without_camera;
  outcome.object_frames = system.object_frames;
  outcome.object_frames_left_out = system.object_frames_left_out;
  outcome.result = SystemResultFile({.sequence = request.sequence,
                                     .build = ThisBuild(),
                                     .system = request.files.name,
                                     .hashes = hashes,
                                     .content = request.content,
                                     .right_shift_px = request.right_shift_px,
                                     .seed = request.seed,
                                     .metrics = outcome.metrics,
                                     .bodies = BodiesOf(outcome.bodies),
                                     .truth = truth,
                                     .estimate = system.objects,
                                     .object_frames = system.object_frames,
                                     .object_frames_left_out = system.object_frames_left_out});
  return outcome;
}

SystemOutcome ScoreSystem(const SystemRequest& request, const fs::path& folder) {
  SystemOutcome outcome = ScoreSystem(request);
  WriteFilesAtomically(folder, {{"result.json", outcome.result}});
  return outcome;
}

}  // namespace cvo
