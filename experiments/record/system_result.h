// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/files/json/json.h"
#include "core/record/run_summary.h"
#include "experiments/datasets/sequence.h"
#include "experiments/metrics/objects/object_matching.h"
#include "experiments/metrics/pose_errors.h"
#include "experiments/record/build_identity.h"

namespace cvo {

// Hashes of the bytes of the files that another system wrote.
struct SystemHashes {
  std::string camera;
  std::string objects;  // empty: no file
};

// Another system's trajectories on a sequence, and their scores.
struct SystemRecord {
  const Sequence& sequence;
  BuildIdentity build;
  std::string system;
  SystemHashes hashes;
  std::string content;          // ContentHash of the sequence
  double right_shift_px = 0.0;  // correction applied to the system's input, not the sequence's
  std::uint64_t seed = 0;
  std::vector<Metric> metrics = {};
  std::optional<reports::RunBodies> bodies = {};  // empty without ground truth or objects
  const ObjectTruth* truth = nullptr;             // may be null
  const ObjectEstimate& estimate;
  int object_frames = 0;
  int object_frames_left_out = 0;
};

// Identity of the job of another system. The whole build is part of it: the readers of the ground
// truth and the geometry needed for scoring are among the estimator's sources.
std::string SystemJob(const BuildIdentity& build, const std::string& system,
                      const SystemHashes& hashes, const std::string& content, std::uint64_t seed);

// Returns the content of result.json, of kind "run" like that of an own run. Poses are the system's
// own, null in frames without one. Throws Error naming a field that is not finite.
std::string SystemResultFile(const SystemRecord& record);

}  // namespace cvo
