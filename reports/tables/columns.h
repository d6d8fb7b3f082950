// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "reports/tables/row_runs.h"
#include "reports/tables/table.h"

namespace cvo::reports {

// The columns for the trajectory of the camera, and those for moving bodies: the paper's ablation
// (its table 4), what was covered, and who is who.
std::vector<std::string> CameraMetrics();
std::vector<std::string> ObjectMetrics();

// With the coverage before each group of metrics that lacks it: accuracy without it favours who
// loses what is hard.
std::vector<std::string> WithCoverage(const std::vector<std::string>& metrics);

// The columns that at least one run has, in the order of `metrics`. Throws Error naming both files
// where two of our own runs mean different things by a metric: anywhere in its definition, or in
// the truth within one type of dataset. Runs of other systems may (DifferingMeaning).
std::vector<Column> MakeColumns(const std::vector<std::string>& metrics,
                                const std::vector<SuiteRun>& runs);

// Why the first run of a row that has the metric means something else by it; empty where none does.
std::string DifferingMeaning(const RowRuns& row, const Column& column);

// Whether a difference between two rows says something: both mean what the column does, and another
// system's row stands on the same corrections of calibrations as the other.
bool AreComparable(const RowRuns& row, const RowRuns& reference, const Column& column);

// Throws Error naming both files unless two runs of one scene mean the same by a metric.
void CheckSameMetric(const RunSummary& a, const MetricValue& in_a, const RunSummary& b,
                     const MetricValue& in_b);

}  // namespace cvo::reports
