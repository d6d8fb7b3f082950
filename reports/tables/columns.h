// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "reports/tables/row_runs.h"
#include "reports/tables/table.h"

namespace cvo::reports {

// The columns for the trajectory of the camera, and those for moving bodies: the ablation of the
// paper (its table 4), coverage, and identity.
std::vector<std::string> CameraMetrics();
std::vector<std::string> ObjectMetrics();

// Inserts the coverage before each group of metrics that lacks it, since accuracy without coverage
// favours whoever loses the hard parts.
std::vector<std::string> WithCoverage(const std::vector<std::string>& metrics);

// The columns that at least one run has a value for, in the order of `metrics`. Throws Error naming
// both files if two of our own runs define a metric differently: in any field of its definition, or
// in the truth within one type of dataset. Runs of other systems may differ (DifferingMeaning).
std::vector<Column> MakeColumns(const std::vector<std::string>& metrics,
                                const std::vector<SuiteRun>& runs);

// How the first run of a row that has the metric defines it differently from the column. Empty if
// it does not.
std::string DifferingMeaning(const RowRuns& row, const Column& column);

// Whether a difference between two rows is meaningful: both define the metric as the column does
// and, if one is of another system, both use the same correction of the calibration.
bool AreComparable(const RowRuns& row, const RowRuns& reference, const Column& column);

// Throws Error naming both files unless two runs of one scene define a metric in the same way.
void CheckSameMetric(const RunSummary& a, const MetricValue& in_a, const RunSummary& b,
                     const MetricValue& in_b);

}  // namespace cvo::reports
