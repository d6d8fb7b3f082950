// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "experiments/datasets/sequence.h"
#include "experiments/metrics/metric.h"
#include "experiments/record/run_record.h"

namespace cvo {

// The camera metrics of a run against the sequence's ground truth. A skipped frame has no estimate;
// a lost frame counts with its predicted pose. Empty where there is no truth or the run failed.
struct RunScores {
  std::vector<Metric> refined;  // camera_*: poses as last estimated
  std::vector<Metric> causal;   // camera_causal_*: poses as estimated when their frame came
};
RunScores ScoreRun(const Sequence& sequence, const RunResult& run);

}  // namespace cvo
