// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/page/collection_html.h"

#include "core/base/error.h"
#include "core/base/lists.h"
#include "reports/formats/table_html.h"
#include "reports/page/html.h"

namespace cvo::reports {
namespace {

std::string Id(std::size_t index) { return StrCat("section-", index + 1); }

std::string Link(const LinkedFile& file) {
  return StrCat("<a href=\"", Escaped(file.path), "\">", Escaped(file.caption), "</a>");
}

std::string Contents(const CollectedPage& page) {
  std::string list;
  for (std::size_t i = 0; i < page.sections.size(); ++i) {
    const CollectedSection& section = page.sections[i];
    const std::string state = !section.problem.empty()   ? ": not on this disk"
                              : !section.missing.empty() ? ": in part"
                                                         : "";
    list += StrCat("<li>", Link({"#" + Id(i), section.title}), state, "</li>\n");
  }
  return StrCat("<nav><ol>\n", list, "</ol></nav>\n");
}

std::string PlainTable(const CollectedSection& section) {
  std::string head;
  for (const std::string& column : section.columns) head += Element("th", column);
  std::string body;
  for (const std::vector<std::string>& row : section.rows) {
    std::string cells;
    for (const std::string& cell : row) cells += Element("td", cell);
    body += StrCat("<tr>", cells, "</tr>\n");
  }
  return StrCat("<div class=\"cvo-scroll\" tabindex=\"0\"><table>\n<thead><tr>", head,
                "</tr></thead>\n<tbody>\n", body, "</tbody>\n</table></div>\n");
}

std::string Missing(const CollectedSection& section) {
  std::string text;
  if (!section.missing.empty()) {
    std::string list;
    for (const std::string& line : section.missing) list += Element("li", line) + "\n";
    text += StrCat("<p>Not on this disk:</p>\n<ul>\n", list, "</ul>\n");
  }
  const bool wanted = !section.problem.empty() || !section.missing.empty();
  if (wanted && !section.data.empty()) text += Element("p", "Get it: " + section.data) + "\n";
  return text;
}

std::string Pictures(const CollectedSection& section) {
  std::string html;
  for (const LinkedFile& picture : section.pictures) {
    html += StrCat("<figure><img src=\"", Escaped(picture.path), "\" alt=\"",
                   Escaped(picture.caption), "\" style=\"max-width: 100%\">",
                   Element("figcaption", picture.caption), "</figure>\n");
  }
  return html;
}

std::string SectionHtml(const CollectedSection& section, std::size_t index) {
  std::string html = Element("h2", section.title) + "\n";
  for (const std::string& paragraph : section.text) html += Element("p", paragraph) + "\n";
  if (!section.columns.empty()) html += PlainTable(section);
  if (section.table) html += TableHtml(*section.table, StrCat("table-", index + 1));
  if (!section.problem.empty()) html += Element("p", "No table: " + section.problem) + "\n";
  html += Missing(section) + Pictures(section);
  if (section.report) html += StrCat("<p>", Link(*section.report), "</p>\n");
  return StrCat("<section id=\"", Id(index), "\">\n", html, "</section>\n");
}

}  // namespace

std::vector<std::string> MissingSequences(const Table& table) {
  std::vector<std::string> missing;
  for (const Problem& problem : table.problems) {
    if (problem.state != "no data") continue;
    AddOnce(StrCat(problem.sequence, ": ", problem.message), missing);
  }
  return missing;
}

std::string CollectionHtml(const CollectedPage& page) {
  std::string body =
      StrCat(Element("h1", page.title), "\n", Element("p", page.about), "\n", Contents(page));
  for (std::size_t i = 0; i < page.sections.size(); ++i) body += SectionHtml(page.sections[i], i);
  return HtmlPage(page.title, body);
}

}  // namespace cvo::reports
