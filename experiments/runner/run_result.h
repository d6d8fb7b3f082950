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
#include "experiments/metrics/objects/object_matching.h"

namespace cvo {

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

// What happened to a sequence's boxes in the processed frames.
struct DetectionCounts {
  int given = 0;          // passed to the estimator
  int outside = 0;        // left out: entirely outside the image
  int skipped = 0;        // left out: in frames without images
  int without_depth = 0;  // passed on unmoved although detected in another camera's image
  std::map<std::string, int> other_classes;  // left out: of classes that were not requested
};

enum class RunStatus {
  kOk,
  kLost,    // some frames have only a predicted pose although their images are fine
  kFailed,  // the estimator gave up; the frames before that are recorded
};
const char* ToString(RunStatus status);

struct RunResult {
  RunStatus status = RunStatus::kOk;
  std::string message;  // empty if ok
  std::string content;  // hash of the sequence: images, text files and parameters
  std::vector<FrameRecord> frames;
  std::vector<ClusterTrajectory> clusters;  // as last estimated, by id; empty if the run failed
  DetectionCounts detections;
  // Wall time of every frame by stage, NaN in frames without this stage. It is measured and
  // therefore never part of a result.
  std::map<std::string, std::vector<float>> times_s;
  double wall_s = 0.0;
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
