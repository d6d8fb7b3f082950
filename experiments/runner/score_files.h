// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "experiments/datasets/sequence.h"
#include "experiments/metrics/objects/object_scores.h"
#include "experiments/metrics/pose_errors.h"
#include "experiments/runner/system_files.h"

namespace cvo {

struct SystemRequest {
  const Sequence& sequence;
  std::string content;  // ContentHash of the sequence
  SystemFiles files;
  std::uint64_t seed = 0;       // of the rendered scene, to compare with runs on it
  double right_shift_px = 0.0;  // correction given to the system, not the sequence's own
};

struct SystemOutcome {
  std::string job;              // IdentifySystem
  std::string result;           // content of result.json
  std::vector<Metric> metrics;  // camera_*, object_*; none that need landmarks
  std::vector<BodyScore> bodies;
  int frames = 0;
  int frames_without_camera = 0;
  int object_frames = 0;
  int object_frames_left_out = 0;
};

// Returns the identity of what ScoreSystem would do, from the bytes of the files. Throws Error for
// a file that cannot be read.
std::string IdentifySystem(const SystemRequest& request);

// Scores the files against the sequence's ground truth in the same way as runs. Bodies are matched
// by nearness, as the contract of each metric states. Throws Error as ReadSystem does.
SystemOutcome ScoreSystem(const SystemRequest& request);

// Does the same and writes result.json to an existing folder.
SystemOutcome ScoreSystem(const SystemRequest& request, const std::filesystem::path& folder);

}  // namespace cvo
