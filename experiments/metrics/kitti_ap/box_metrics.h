// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "experiments/datasets/sequence.h"
#include "experiments/metrics/metric.h"

namespace cvo {

// Whether the sequence has a label of a car with a 3D box, without which there are no BoxMetrics.
bool TellsBoxes(const Sequence& sequence);

// Computes box_ap_*: the average precision of the cars among a run's boxes, at an overlap of 0.25
// as in the paper and with labels interpreted as the devkit does. Empty if no label is a car with a
// 3D box; a level without labels is left out.
std::vector<Metric> BoxMetrics(const Sequence& sequence, const std::vector<ObjectBox>& boxes);

}  // namespace cvo
