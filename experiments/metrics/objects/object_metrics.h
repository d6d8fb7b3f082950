// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "experiments/metrics/metric.h"
#include "experiments/metrics/objects/object_scores.h"

namespace cvo {

// Computes the object metrics, in a fixed order: object_* over moving bodies, object_predicted_*
// over the frames in which their estimate does not count (Counts), object_standing_* over
// stationary bodies, and the number of clusters without a body. A metric that the bodies do not
// determine is absent.
std::vector<Metric> ObjectMetrics(const ObjectTruth& truth, const ObjectScores& scores);

}  // namespace cvo
