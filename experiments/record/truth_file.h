// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "experiments/metrics/objects/object_matching.h"
#include "experiments/metrics/objects/object_scores.h"

namespace cvo {

// The ground truth that a run was compared to; nullptr: there is none.
struct TruthRecord {
  const OptionalPoses* camera = nullptr;  // by processed frame
  const ObjectTruth* objects = nullptr;
  RigidTransform truth_from_estimate;  // between the worlds
  const std::vector<BodyScore>* bodies = nullptr;
};

// Returns the content of truth.json, for drawing: the ground truth in the world of the run, which
// is the first left camera as estimated, and for each body the positions from which its ATE is
// computed. Frames count from the first one processed; poses are as in result.json.
std::string TruthFile(const std::string& job, const TruthRecord& truth);

}  // namespace cvo
