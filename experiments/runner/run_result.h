// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/geometry/stereo_camera.h"
#include "core/interface/frame.h"
#include "core/record/run_summary.h"
#include "experiments/datasets/sequence.h"
#include "experiments/metrics/objects/object_scores.h"
#include "experiments/runner/given.h"
#include "experiments/runner/identity.h"
#include "variants/registry.h"

namespace cvo {

class FrontEndCache;

// What a run is asked to do.
struct RunRequest {
  const Sequence& sequence;
  const VariantInfo& variant;
  Options options;
  std::uint64_t seed = 0;
  int threads = 1;                                    // results do not depend on it
  std::vector<std::string> classes = RigidClasses();  // of the detections that are used
  OracleSwitches oracle = {};
  bool landmarks = false;                // RunJob writes landmarks.csv
  std::vector<ImageHashes> images = {};  // of every frame, from HashImages; empty: unknown
  const FrontEndCache* cache = nullptr;  // needs `images`; results do not depend on it
  std::function<void(std::size_t done)> progress = [](std::size_t) {};
  std::function<bool()> stop = [] { return false; };  // called after every frame
};

// An image that could not be decoded.
struct ImageProblem {
  std::string image;   // its path within the sequence's folder
  std::string reason;  // what was found and what was expected
};

// One frame of a run.
struct FrameRecord {
  int frame = 0;  // as numbered in the sequence's folder
  std::int64_t timestamp_ns = 0;
  // With the poses as estimated when the frame was processed, and without its landmarks: they would
  // take many times the memory of all else.
  FrameReport report;
  RigidTransform refined_world_from_camera;    // as last estimated, at the end of the run
  std::vector<Detection> detections;           // as given to the estimator
  std::vector<LandmarkObservation> landmarks;  // counts; only where bodies have a ground truth
  std::vector<ImageProblem> problems;          // why the frame was skipped
};

enum class RunStatus {
  kOk,
  kLost,    // some frames have only a predicted pose although their images are fine
  kFailed,  // the estimator gave up; the frames before that are recorded
};
const char* ToString(RunStatus status);

// The metrics of a run against the sequence's ground truth. A skipped frame has no estimate; a lost
// frame counts with its predicted pose. Empty if there is no ground truth or the run failed.
struct RunScores {
  std::vector<Metric> metrics;         // refined, causal, clustering, boxes, calibration
  RigidTransform truth_from_estimate;  // between the worlds, from refined poses
  std::vector<BodyScore> refined_bodies;
  std::vector<BodyScore> causal_bodies;
};

// A run: what it was asked to do, what came of it, and how good that is.
struct RunResult : RunRequest {
  explicit RunResult(const RunRequest& request) : RunRequest(request) {}

  RunStatus status = RunStatus::kOk;
  std::string message;  // empty if ok
  std::string content;  // hash of the sequence: images, text files and parameters
  std::string images_hash;
  std::string job;  // JobIdentity
  std::vector<FrameRecord> frames;
  std::vector<ClusterTrajectory> clusters;  // as last estimated, by id; empty if it failed
  DetectionCounts detections;
  // Wall time of every frame by stage, NaN in frames without this stage. It is measured and
  // therefore never part of a result.
  std::map<std::string, std::vector<float>> times_s;
  double wall_s = 0.0;
  double cpu_s = 0.0;  // the same, of all threads
  // From RunJob on:
  RunScores scores;
  std::vector<std::string> warnings;  // of FindImplausible
  reports::TimingData timing;
};

// Whether no pose was estimated for the frame, so that the trajectory contains a predicted one.
inline bool IsPredicted(const FrameRecord& frame) {
  return frame.report.status == FrameStatus::kLost || frame.report.status == FrameStatus::kSkipped;
}

// A live cluster in a frame, as reported when the frame was processed and as last estimated. At
// least one of the two is set.
struct LiveCluster {
  const FrameRecord& frame;
  ClusterId id;
  const ClusterReport* causal = nullptr;   // null: not yet confirmed when the frame was processed
  const ClusterReport* refined = nullptr;  // null: the run failed

  const ClusterReport& Last() const { return refined ? *refined : *causal; }
  RigidTransform CameraFromBox() const;
};

// Calls `take` for all rows of a run, by frame, then by id.
void ForEachLiveCluster(const RunResult& run, const std::function<void(const LiveCluster&)>& take);

// Returns the bounding rectangle of the part of the cluster's 3D box that is in front of the
// camera, clipped to the image. Empty if nothing of it is visible.
[[nodiscard]] std::optional<ImageBox> ProjectedBox(const LiveCluster& row,
                                                   const StereoCamera& camera);

}  // namespace cvo
