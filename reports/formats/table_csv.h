// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "reports/tables/table.h"

namespace cvo::reports {

// CSV by RFC 4180 with all digits. Texts that a spreadsheet would take for a formula begin with an
// apostrophe; control characters but line ends are replaced. One record per row of the table and
// per line of others' figures: value, interval and marks of each column side by side.
std::string TableCsv(const Table& table);

// One record per cell: all that the table knows of it.
std::string TableLongCsv(const Table& table);

}  // namespace cvo::reports
