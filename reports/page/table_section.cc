// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/formats/table_html.h"
#include "reports/page/html.h"
#include "reports/page/page_parts.h"

namespace cvo::reports {

std::string TableFrame(const Table& table, const std::string& name) {
  return "<div data-table=\"" + name + "\">\n" + TableHtml(table, name + "-results") + "</div>\n";
}

std::string TableSection(const PageContent& content) {
  std::string html = "<section id=\"table\">\n<h2>Table</h2>\n";
  if (!content.table) {
    return html + "<p class=\"problem\">There is no table: see above.</p>\n</section>\n";
  }
  html +=
      "<p>Each value is a mean, with its 95 % interval and the number of bodies or scenes below "
      "it. A star marks a significant difference from the reference. Grey rows are published "
      "results of others, with their sources in the notes below; values in brackets are not "
      "comparable with ours. Select a cell to see its runs, and a heading to sort by it.</p>\n";
  return html + TableFrame(*content.table, "table") + "</section>\n";
}

}  // namespace cvo::reports
