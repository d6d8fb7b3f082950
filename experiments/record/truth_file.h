// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "experiments/metrics/objects/object_scores.h"
#include "experiments/metrics/objects/object_truth.h"

namespace cvo {

// What a run was held against; nullptr: there is none.
struct TruthRecord {
  const OptionalPoses* camera = nullptr;  // by frame run
  const ObjectTruth* objects = nullptr;
  RigidTransform truth_from_estimate;  // of the worlds
  const std::vector<BodyScore>* bodies = nullptr;
};

// The content of truth.json, for pictures: the truth in the world of the run, which is the first
// left camera as estimated, and of each body the positions that its ATE is made of. Frames count
// from the first one run, poses are as in result.json.
std::string TruthFile(const std::string& job, const TruthRecord& truth);

}  // namespace cvo
