// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "experiments/metrics/metric.h"
#include "experiments/metrics/objects/object_matching.h"

namespace cvo {

// Measures how well observed landmarks are assigned to bodies: moving_precision and moving_recall;
// cluster_purity, which also counts stationary bodies; clustering_iou (the cluster of a body is
// that of `matches`) and clustering_ari. Landmarks of unknown truth, and those on a body that has
// not moved yet, are left out. Landmarks on a body that has stopped still count as that body's.
// A metric that the landmarks do not determine is absent.
std::vector<Metric> ClusteringMetrics(const ObjectTruth& truth, const ObjectEstimate& estimate,
                                      const std::vector<ObjectMatch>& matches);

// Adjusted Rand index of two labellings of the same items (Hubert and Arabie 1985). An item with a
// negative label is a group of its own. 1 if both labellings agree on every pair.
double AdjustedRandIndex(const std::vector<int>& a, const std::vector<int>& b);

}  // namespace cvo
