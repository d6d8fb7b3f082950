// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "reports/tables/table.h"

namespace cvo::reports {

// table.json: the same bytes for the same results. Throws Error naming a value that is not finite.
std::string TableJson(const Table& table);

// A table.json read back: TableJson gives the same bytes again. What only results know is left at
// its default: the pair of a source. Throws Error naming `where` and the field: half-written, of
// another schema version, no table.
Table ReadTable(std::string_view json, const std::string& where);

}  // namespace cvo::reports
