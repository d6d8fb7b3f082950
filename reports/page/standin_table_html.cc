// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/page/standin_table_html.h"

#include "core/base/error.h"
#include "reports/page/html.h"
#include "reports/page/quantity.h"

namespace cvo::reports {
std::string TableHtml(const Table& table) {
  std::string h =
      "<table class=\"results\"><caption>" + Escaped(table.title) + "</caption>\n<thead><tr>";
  for (const auto& k : table.keys) h += StrCat("<th scope=\"col\">", Escaped(k), "</th>");
  for (const auto& c : table.columns)
    h += StrCat("<th scope=\"col\">", Escaped(c.label), " [", Escaped(c.unit), "]</th>");
  h += "</tr></thead>\n<tbody>\n";
  for (std::size_t r = 0; r < table.rows.size(); ++r) {
    h += "<tr>";
    for (const auto& k : table.rows[r].keys) h += StrCat("<th scope=\"row\">", Escaped(k), "</th>");
    for (std::size_t c = 0; c < table.rows[r].cells.size(); ++c) {
      const Cell& cell = table.rows[r].cells[c];
      h += StrCat("<td data-row=\"", r, "\" data-column=\"", c, "\"");
      if (cell.present) h += StrCat(" data-value=\"", cell.value, "\"");
      h += StrCat(">", cell.present ? Escaped(QuantityText(cell.value, table.columns[c].unit)) : std::string("-"), "</td>");
    }
    h += "</tr>\n";
  }
  return h + "</tbody></table>\n";
}
}  // namespace cvo::reports
