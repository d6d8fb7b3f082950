// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "experiments/metrics/metric.h"
#include "experiments/metrics/pose_errors.h"

namespace cvo {

// The camera metrics of one run, in a fixed order: camera_coverage, camera_ate (root mean square)
// with _mean, _median and _max, camera_{r,t}rpe_all_pairs, camera_{r,t}rpe_1_frame and
// camera_{t,r}_drift. Poses are world_from_camera per frame, empty where there is none; equal
// lengths. A metric that the frames do not determine is absent. `source` enters the contracts.
// Throws Error for poses that are not finite.
std::vector<Metric> EvaluateCamera(const OptionalPoses& truth, const OptionalPoses& estimate,
                                   std::optional<reports::TruthSource> source = {});

// nullptr where the metric is absent.
const Metric* FindMetric(const std::vector<Metric>& metrics, const std::string& name);

}  // namespace cvo
