// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "experiments/metrics/metric.h"
#include "experiments/metrics/pose_errors.h"

namespace cvo {

// Computes the camera metrics of one run, in a fixed order: camera_coverage, camera_ate (root mean
// square) with _mean, _median and _max, camera_{r,t}rpe_all_pairs, camera_{r,t}rpe_1_frame,
// camera_{t,r}_drift, and camera_max_drift with its angles under each of three contracts. Poses are
// world_from_camera per frame, empty if there is none; both lists have the same length. A metric
// that the frames do not determine is absent. `source` enters the contracts. Throws Error if a pose
// is not finite.
std::vector<Metric> EvaluateCamera(const OptionalPoses& truth, const OptionalPoses& estimate,
                                   std::optional<reports::TruthSource> source = {});

// Returns the metric of this name; nullptr if it is absent.
const Metric* FindMetric(const std::vector<Metric>& metrics, const std::string& name);

}  // namespace cvo
