// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "reports/tables/table.h"

namespace cvo::reports {

// Returns a <section> with the values as a <table>, the differences as another, and their notes.
// Cells of metric columns carry data-row and data-column, which are indices into the Table, and
// data-value if there is a number. A line of published figures carries data-reference: its index in
// the row or, without data-row, in Table::others. `id` begins the ids of elements and must be
// unique within a page.
std::string TableHtml(const Table& table, const std::string& id = "table");

// Returns a page with the given body: no scripts, nothing from the network, light and dark style.
std::string HtmlPage(const std::string& title, const std::string& body);

}  // namespace cvo::reports
