// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "reports/tables/reference.h"
#include "reports/tables/table.h"

namespace cvo::reports {

// Adds what other systems reach on the sequences of the table, below our rows: first the rows with
// a comparable figure, then the rest, with the reason in each cell that is not comparable. Figures
// for a whole suite come below all rows.
void AddReferenceRows(const Reference& reference, Table& table);

}  // namespace cvo::reports
