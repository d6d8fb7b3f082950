// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// The page about the results of a suite: what it shows, and its HTML.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "reports/figures/suite_figures.h"
#include "reports/tables/table.h"

namespace cvo::reports {

// A name and a value, both for readers.
using Fact = std::pair<std::string, std::string>;

// A drawn left image.
struct PageImage {
  int frame = 0;  // number in the folder of the sequence
  std::string jpeg;
  std::string alt;  // what the picture shows, in words
};

// A run whose images are shown frame by frame.
struct PageScene {
  std::size_t run = 0;  // index in PageContent::runs
  std::vector<PageImage> images = {};
  std::string no_images = {};  // why there are none
};

// Everything that a page shows. A part that could not be made is empty, and `problems` says why.
struct PageContent {
  std::string title;
  std::string about;
  std::optional<Table> table;
  std::vector<SuiteRun> runs;  // in the order of the plan
  std::vector<Fact> variants;  // variants of the suite, each with its meaning
  SuiteFigures drawing;
  std::vector<PageScene> scenes;
  std::vector<std::string> origins;  // the programs and machines that made the results
  std::vector<std::string> missing;  // files that cannot be read, and why
  std::vector<std::string> problems;
};

struct PageRequest {
  std::filesystem::path folder;  // output folder of a suite
  std::string default_options;   // nested JSON; empty: unknown
  std::vector<Fact> variants;    // all variants, each with its meaning
};

// Reads whatever can be read from the folder. Throws Error only if it holds no plan.json.
PageContent ReadPage(const PageRequest& request);

// Chooses the run of each sequence whose images are shown: of `full`, else of the reference of the
// table, else of the first variant; of its seeds the lowest.
void ChooseScenes(PageContent& content);

// One self-contained page, which needs no network. The same content gives the same bytes. All
// statements are in its HTML; its script only sorts, unfolds and moves through frames.
std::string PageHtml(const PageContent& content);

// ---- The parts of pages as HTML. Every text given to these functions is escaped.

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

// What the suite compared.
std::string SummarySection(const PageContent& content);

}  // namespace cvo::reports
