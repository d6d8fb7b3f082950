// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// The parts of pages as HTML. Every text given to these functions is escaped.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "reports/page/page.h"

namespace cvo::reports {

// Escapes a text, on one line, for use between tags or in a quoted attribute.
std::string Escaped(std::string_view text);

// Returns <tag>text</tag>.
std::string Element(const std::string& tag, std::string_view text);

// A heading, if it is not empty, and one item for each text; empty if there is none.
std::string ListHtml(const std::string& heading, const std::vector<std::string>& texts);

// A list of names and values; empty if there is none.
std::string FactsHtml(const std::vector<Fact>& facts);

// The values of a table, its differences as a second one, and its notes. `id` begins the ids of
// elements and must be unique within a page.
std::string ResultTable(const Table& table, const std::string& id);

// A complete page with this body. No script but our own can run in it, and nothing is loaded from
// the network.
std::string HtmlDocument(const std::string& title, const std::string& body);

// The files page.css and page.js.
std::string_view PageStyle();
std::string_view PageScript();

// Sections of the page of a suite. Each is there even if it only says that there is nothing to
// show, except that a page compared with nothing has no comparison.
std::string SummarySection(const PageContent& content);
std::string ComparisonSection(const PageContent& content);
std::string FramesSection(const PageContent& content);

// What differs between the rows of a table and their reference.
std::string FindingsHtml(const Table& table, const std::string& reference);

}  // namespace cvo::reports
