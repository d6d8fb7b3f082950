// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "reports/tables/table.h"

namespace cvo::reports {

// "[a]", "[b]", ...: a source of reference rows.
std::string SourceMark(std::size_t source);

// What a reader must know of the figures: runs that are missing, what intervals mean, what values
// leave out, and where figures of others come from.
std::vector<std::string> Footnotes(const Table& table);

// What each column is, by its contract.
std::vector<std::string> Definitions(const Table& table);

}  // namespace cvo::reports
