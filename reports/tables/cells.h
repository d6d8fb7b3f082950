// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "reports/tables/row_runs.h"
#include "reports/tables/table.h"

namespace cvo::reports {

// The runs of a row and of its reference, with the keys that identify rows.
struct PairedRows {
  const std::vector<std::string>& keys;
  const RowRuns& row;
  const RowRuns& reference;
  std::string reference_label;
};

// The mean of a metric over the runs of a row: over seeds, then bodies, then scenes.
Cell MakeCell(const RowRuns& row, const std::vector<std::string>& keys, const Column& column);

// The paired difference of a row to its reference. Empty if the two have nothing in common. Throws
// Error naming both files if two runs of one scene define the metric differently.
std::optional<Difference> MakeDifference(const PairedRows& rows, const Column& column);

}  // namespace cvo::reports
