// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "reports/tables/reference.h"
#include "reports/tables/table.h"

namespace cvo::reports {

// What others reach on the sequences of the table, below our rows: first figures that compare, then
// the rest, each cell with why it does not. Figures for a suite come below all rows.
void AddReferenceRows(const Reference& reference, Table& table);

}  // namespace cvo::reports
