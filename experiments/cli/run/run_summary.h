// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <iosfwd>
#include <vector>

#include "experiments/datasets/sequence.h"
#include "experiments/log/run_record.h"
#include "experiments/metrics/metric.h"
#include "experiments/runner/score_run.h"

namespace cvo {

// One line: how many boxes the estimator was given, and why others were left out. Nothing if
// none were asked for. A second one where scores are 0 or negative, as margins are.
void PrintDetections(const Sequence& sequence, const DetectionCounts& counts, std::ostream& out);

// Metrics side by side with refined and with causal poses, the eight that matter most or all, then
// a line per body.
void PrintScores(const RunScores& scores, bool all, std::ostream& out);

// A line per body that is visible in some frame; the metrics are theirs.
void PrintBodies(const std::vector<BodyScore>& bodies, const std::vector<Metric>& metrics,
                 std::ostream& out);

// Name, value, unit and number of errors, one metric per line.
void PrintMetrics(const std::vector<Metric>& metrics, std::ostream& out);

}  // namespace cvo
