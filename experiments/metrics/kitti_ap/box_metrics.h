// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "experiments/datasets/sequence.h"
#include "experiments/metrics/metric.h"

namespace cvo {

// Whether a label of the sequence is a car with a 3D box: there are no BoxMetrics otherwise.
bool TellsBoxes(const Sequence& sequence);

// box_ap_*: average precision of the cars among a run's boxes, at an overlap of 0.25 as in the
// paper and with the devkit's own reading of labels. Empty where no label is a car with a 3D box,
// and of a level that no label is of.
std::vector<Metric> BoxMetrics(const Sequence& sequence, const std::vector<ObjectBox>& boxes);

}  // namespace cvo
