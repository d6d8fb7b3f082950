// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "reports/tables/run_summary.h"
#include "reports/tables/table.h"

namespace cvo::reports {

// The columns that at least one run has, in the order of `metrics`. Throws Error naming both files
// where two runs mean different things by a metric.
std::vector<Column> MakeColumns(const std::vector<std::string>& metrics,
                                const std::vector<const RunSummary*>& runs);

}  // namespace cvo::reports
