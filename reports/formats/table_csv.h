// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "reports/tables/table.h"

namespace cvo::reports {

// Returns the table as CSV (RFC 4180) with all digits. Texts that a spreadsheet would take for a
// formula are prefixed with an apostrophe; control characters other than line ends are replaced.
// There is one record per row of the table and per line of published figures, with value, interval
// and marks of each column side by side.
std::string TableCsv(const Table& table);

// Returns one record per cell, with everything that the table knows about it.
std::string TableLongCsv(const Table& table);

}  // namespace cvo::reports
