// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <iosfwd>
#include <vector>

#include "experiments/datasets/sequence.h"
#include "experiments/metrics/pose_errors.h"
#include "experiments/runner/run_result.h"
#include "experiments/runner/score_run.h"

namespace cvo {

// Prints in one line how many boxes the estimator was given and why others were left out, or
// nothing if no boxes were requested. A second line warns if some scores are negative, as margins
// are.
void PrintDetections(const Sequence& sequence, const DetectionCounts& counts, std::ostream& out);

// Prints the metrics of refined and causal poses side by side, either all or the eight most
// important, then a line per body.
void PrintScores(const RunScores& scores, bool all, std::ostream& out);

// Prints a line per body that is visible in some frame. `metrics`: those of these bodies.
void PrintBodies(const std::vector<BodyScore>& bodies, const std::vector<Metric>& metrics,
                 std::ostream& out);

// Prints one metric per line: name, value, unit and number of errors.
void PrintMetrics(const std::vector<Metric>& metrics, std::ostream& out);

}  // namespace cvo
