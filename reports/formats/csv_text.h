// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace cvo::reports {

// A text as a field: harmless in a terminal and a spreadsheet, quoted where it must be.
std::string CsvField(const std::string& text);

// Joins fields that are written as they are.
std::string CsvRecord(const std::vector<std::string>& fields);

}  // namespace cvo::reports
