// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "experiments/metrics/metric.h"
#include "experiments/metrics/objects/object_matching.h"

namespace cvo {

// How well observed landmarks are told apart: moving_precision and moving_recall; cluster_purity,
// for which bodies that stand count too; clustering_iou (a body's own cluster is the one of
// `matches`) and clustering_ari. Landmarks of unknown truth and those on a body that has not moved
// yet count neither way; on one that has stopped they are still an object's. A metric that the
// landmarks do not determine is absent.
std::vector<Metric> ClusteringMetrics(const ObjectTruth& truth, const ObjectEstimate& estimate,
                                      const std::vector<ObjectMatch>& matches);

// The adjusted Rand index of two labellings of the same things (Hubert and Arabie 1985); a label
// below zero is a group of one. 1 where both say the same of every pair.
double AdjustedRandIndex(const std::vector<int>& a, const std::vector<int>& b);

}  // namespace cvo
