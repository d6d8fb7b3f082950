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

// What became of a sequence's boxes, over the frames that were processed.
struct DetectionCounts {
  int given = 0;          // to the estimator
  int outside = 0;        // left out: no pixel of the image inside
  int skipped = 0;        // left out: of frames without images
  int without_depth = 0;  // given where they were drawn, though another camera saw them there
  std::map<std::string, int> other_classes;  // left out: of classes that were not asked for
};

enum class RunStatus {
  kOk,
  kLost,    // some frames have only a predicted pose though their images are fine
  kFailed,  // the estimator gave up; the frames before are there
};
const char* ToString(RunStatus status);

struct RunResult {
  RunStatus status = RunStatus::kOk;
  std::string message;  // empty where ok
  std::string content;  // hash of the sequence: images, text files and parameters
  FrameLog frames = FrameLog();
  PoseLog clusters = PoseLog();  // trajectories as last estimated; none of a failed run
  DetectionCounts detections;
  // Wall time of every frame by stage, NaN where it had no such stage. Measured, so never part of a
  // result.
  std::map<std::string, std::vector<double>> times_s;
  double wall_s = 0.0;
};

// No pose was estimated for the frame: it stands in the trajectory with a predicted one.
inline bool IsPredicted(const FrameRecord& frame) {
  return frame.report.status == FrameStatus::kLost || frame.report.status == FrameStatus::kSkipped;
}

}  // namespace cvo
