// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/files/json/json.h"
#include "experiments/datasets/sequence.h"
#include "experiments/metrics/metric.h"
#include "experiments/metrics/objects/object_estimate.h"
#include "experiments/record/build_identity.h"
#include "reports/results/run_summary.h"

namespace cvo {

// The files that another system wrote, by their bytes.
struct SystemHashes {
  std::string camera;
  std::string objects;  // empty: none
};

// What a result says of another system's trajectories on a sequence.
struct SystemRecord {
  const Sequence& sequence;
  BuildIdentity build;
  std::string system;
  SystemHashes hashes;
  std::string content;          // ContentHash of the sequence
  double right_shift_px = 0.0;  // correction that the system was given, not the sequence's
  std::uint64_t seed = 0;
  std::vector<Metric> metrics = {};
  std::optional<reports::RunBodies> bodies = {};  // empty without truth or objects
  const ObjectTruth* truth = nullptr;             // may be null
  const ObjectEstimate& estimate;
  int object_frames = 0;
  int object_frames_left_out = 0;
};

// Of a run of no variant. The whole build takes part: the readers of the truth and the geometry
// that scoring needs are among the estimator's sources.
std::string SystemJob(const BuildIdentity& build, const std::string& system,
                      const SystemHashes& hashes, const std::string& content, std::uint64_t seed);

// The content of result.json, kind "run" as of an own run; poses are the system's own, those of
// frames without one null. Throws Error naming a field that is not finite.
std::string SystemResultFile(const SystemRecord& record);

}  // namespace cvo
