// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "reports/tables/table.h"

namespace cvo::reports {

// By how many percent the error of a cell is lower than that of its reference, over what the two
// have in common; negative if it is higher. For a share that should be large, the error is what is
// missing to 1. Empty if there is no difference or the reference has no error.
std::optional<double> ErrorReduction(const Cell& cell, const Column& column);

}  // namespace cvo::reports
