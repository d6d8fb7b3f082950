// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "reports/tables/table.h"

namespace cvo::reports {

// A <section> with the values as <table>, the differences as another, and their notes. Cells of
// columns carry data-row and data-column, indices in the Table, and data-value where there is a
// number; a line of others' figures has data-reference, its index in the row or, without data-row,
// in Table::others. `id` begins the ids of elements: one per table of a page.
std::string TableHtml(const Table& table, const std::string& id = "table");

// The same as a page of its own: no scripts, nothing from the network, light and dark.
std::string TableHtmlPage(const Table& table);

// A page of that kind with any body.
std::string HtmlPage(const std::string& title, const std::string& body);

}  // namespace cvo::reports
