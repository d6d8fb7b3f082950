// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "reports/formats/table_texts.h"

namespace cvo::reports {

// Splits a table that is too wide into parts. Returns the indices of the columns of each part: from
// left to right as many as fit, at least one, and never an accuracy without its coverage.
std::vector<std::vector<std::size_t>> SplitColumns(const std::vector<ColumnText>& columns,
                                                   const std::vector<double>& widths, double room);

// Whether the line has a value, or lacks one that it should have, in any of these columns.
bool HasValue(const TextLine& line, const std::vector<std::size_t>& columns);

}  // namespace cvo::reports
