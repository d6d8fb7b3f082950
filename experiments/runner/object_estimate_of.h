// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "experiments/metrics/object_estimate.h"
#include "experiments/record/run_record.h"

namespace cvo {

// What a run says of the bodies, with poses as when their frame came or as last estimated. Skipped
// frames have no camera. One entry per frame of the run.
enum class PoseTime { kCausal, kRefined };
ObjectEstimate ObjectEstimateOf(const RunResult& run, PoseTime time);

}  // namespace cvo
