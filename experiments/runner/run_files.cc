// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/runner/run_files.h"

#include <system_error>
#include <utility>

#include "core/base/error.h"
#include "experiments/metrics/trajectory.h"
#include "experiments/record/cluster_tables.h"
#include "experiments/record/landmark_table.h"

namespace cvo {
namespace {

namespace fs = std::filesystem;

constexpr const char* kClusters = "clusters";
constexpr const char* kLandmarks = "landmarks.csv";
constexpr const char* kTruth = "truth.json";

// Returns the <number>.tum files in clusters/ that this run does not write.
std::vector<std::string> StaleFiles(const fs::path& folder, const StagedFiles& written) {
  std::vector<std::string> stale;
  std::error_code none;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder / kClusters, none)) {
    const std::string stem = entry.path().stem().string();
    if (entry.path().extension() != ".tum" ||
        stem.find_first_not_of("0123456789") != std::string::npos) {
      continue;
    }
    stale.push_back(StrCat(kClusters, "/", entry.path().filename().string()));
  }
  std::erase_if(stale, [&](const std::string& name) { return written.Has(name); });
  return stale;
}

std::string CameraTum(const std::vector<FrameRecord>& frames) {
  Trajectory timed;
  for (const FrameRecord& frame : frames) {
    if (frame.report.status == FrameStatus::kSkipped) continue;
    timed.push_back({frame.timestamp_ns, frame.refined_world_from_camera});
  }
  return FormatTumTrajectory(timed);
}

std::string CameraKitti(const std::vector<FrameRecord>& frames) {
  std::vector<RigidTransform> every_frame;
  for (const FrameRecord& frame : frames) every_frame.push_back(frame.refined_world_from_camera);
  return FormatKittiPoses(every_frame);
}

}  // namespace

std::vector<std::string> RunFileNames() {
  return {"camera.tum", "camera.kitti", "objects.csv", "tracks.kitti", kLandmarks,
          "clusters/",  kTruth,         "timing.json", "result.json"};
}

StagedFile BeginLandmarks(const fs::path& folder) {
  StagedFile file(folder / kLandmarks);
  file.Append(kLandmarksHeader);
  return file;
}

void WriteRunFiles(const fs::path& folder, const RunRecord& record, const RunContext& context,
                   std::optional<StagedFile> landmarks) {
  const RunResult& run = record.run;
  StagedFiles files(folder);
  const bool has_landmarks = landmarks.has_value();
  if (landmarks) files.Add(std::move(*landmarks));
  for (const ClusterTrajectory& cluster : run.clusters) {
    files.Add(StrCat(kClusters, "/", cluster.id.value, ".tum"), ClusterTum(cluster));
  }
  files.Add("camera.tum", CameraTum(run.frames));
  files.Add("camera.kitti", CameraKitti(run.frames));
  files.Add("objects.csv",
            [&](const TextSink& sink) { WriteObjectTable(record.sequence, run, sink); });
  files.Add("tracks.kitti",
            [&](const TextSink& sink) { WriteKittiTracks(record.sequence, run, sink); });
  files.Add(kTruth, TruthFile(RecordedJob(record), record.truth));
  // The result comes last: if it is complete, so is everything else.
  files.Add("timing.json", [&](const TextSink& sink) { WriteTimingFile(run, context, sink); });
  files.Add("result.json", [&](const TextSink& sink) { WriteResultFile(record, sink); });
  std::vector<std::string> stale = StaleFiles(folder, files);
  if (!has_landmarks && fs::exists(folder / kLandmarks)) stale.emplace_back(kLandmarks);
  files.Publish(stale);
}

}  // namespace cvo
