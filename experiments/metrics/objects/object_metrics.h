// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "experiments/metrics/metric.h"
#include "experiments/metrics/objects/object_scores.h"

namespace cvo {

// The object rows in a fixed order: object_* over movers, object_predicted_* where
// their pose is a prediction, object_standing_* over bodies that stay put, and clusters without a
// body. A metric that the bodies do not determine is absent.
std::vector<Metric> ObjectMetrics(const ObjectTruth& truth, const ObjectScores& scores);

}  // namespace cvo
