// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "reports/tables/table.h"

namespace cvo::reports {

// By how many percent a cell has less error than its reference, on what the two have in common;
// negative: more. The error of a share that should be large is what is missing to 1. Empty without
// a difference and where the reference has no error.
std::optional<double> ErrorReduction(const Cell& cell, const Column& column);

}  // namespace cvo::reports
