// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "experiments/log/frame_log.h"
#include "experiments/log/pose_log.h"

namespace cvo {

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
  FrameLog frames = FrameLog();
  PoseLog clusters = PoseLog();  // trajectories as last estimated; empty if the run failed
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

}  // namespace cvo
