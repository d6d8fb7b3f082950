// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "reports/tables/row_runs.h"
#include "reports/tables/table.h"

namespace cvo::reports {

// Runs and reference of a row, with the keys that tell rows apart.
struct PairedRows {
  const std::vector<std::string>& keys;
  const RowRuns& row;
  const RowRuns& reference;
  std::string reference_label;
};

// The mean of a metric over the runs of a row: seeds, then bodies, then scenes.
Cell MakeCell(const RowRuns& row, const std::vector<std::string>& keys, const Column& column);

// Empty where the rows have nothing in common. Throws Error naming both files where two runs of one
// scene mean different things by the metric.
std::optional<Difference> MakeDifference(const PairedRows& rows, const Column& column);

}  // namespace cvo::reports
