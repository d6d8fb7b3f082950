// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace cvo::reports {

// Returns a text as a CSV field: harmless in a terminal and a spreadsheet, quoted if necessary.
std::string CsvField(const std::string& text);

// Joins fields, which are written as they are, into a record.
std::string CsvRecord(const std::vector<std::string>& fields);

}  // namespace cvo::reports
