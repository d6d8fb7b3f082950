// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>

#include "reports/tables/table.h"

namespace cvo::reports {

// Aligned columns with their units, then footnotes but no definitions. `dim`: figures that do not
// compare are faint as well as in brackets, by terminal codes. What is wider than `width` is
// several tables, each accuracy beside its coverage; 0: as wide as it is.
std::string TableText(const Table& table, bool dim, std::size_t width = 0);

// The same as Markdown, with the definitions of the columns.
std::string TableMarkdown(const Table& table);

}  // namespace cvo::reports
