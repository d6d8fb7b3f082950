// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>

#include "reports/tables/table.h"

namespace cvo::reports {

// Returns aligned columns with their units, then footnotes but no definitions. With `dim`, figures
// that are not comparable are dimmed by terminal codes in addition to their brackets. A table wider
// than `width` is split into several, each accuracy beside its coverage; 0: no limit.
std::string TableText(const Table& table, bool dim, std::size_t width = 0);

// The same as Markdown, with the definitions of the columns.
std::string TableMarkdown(const Table& table);

}  // namespace cvo::reports
