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

// One self-contained page, which needs no network. Its first screen has what was compared, the
// short table, the differences from the reference and the images of the first run; all else is
// folded. The same content gives the same bytes. All statements are in its HTML; its script only
// sorts, unfolds and moves through frames.
std::string PageHtml(const PageContent& content);

// Escapes a text, on one line, for use between tags or in a quoted attribute.
std::string Escaped(std::string_view text);

// All values of a table, its differences as a second one, and its notes.
std::string ResultTable(const Table& table);

// The files page.css and page.js.
std::string_view PageStyle();
std::string_view PageScript();

}  // namespace cvo::reports
