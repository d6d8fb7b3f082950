// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "reports/tables/table.h"

namespace cvo::reports {

// The text of table.json. The same results give the same bytes. Throws Error naming the value if
// one is not finite.
std::string TableJson(const Table& table);

// Reads a table.json; TableJson returns the same bytes for it. The pair of a source, which is not
// in the file, is left at its default. Throws Error naming `where` and the field if the text is
// truncated, of another schema version, or no table.
Table ReadTable(std::string_view json, const std::string& where);

}  // namespace cvo::reports
