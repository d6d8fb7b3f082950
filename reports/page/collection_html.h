// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "reports/tables/table.h"

namespace cvo::reports {

// A file beside the page.
struct LinkedFile {
  std::string path;  // relative to the page
  std::string caption;
};

// A table or figure of a page of several suites.
struct CollectedSection {
  std::string title;
  std::vector<std::string> text;
  std::vector<std::string> columns;  // of a table of texts; empty: none
  std::vector<std::vector<std::string>> rows;
  std::optional<Table> table;
  std::string problem;               // why there is no table; empty: it says so itself
  std::vector<std::string> missing;  // sequences that are not on this disk
  std::string data;                  // where to get them
  std::vector<LinkedFile> pictures;
  std::optional<LinkedFile> report;  // the suite's own page
};

struct CollectedPage {
  std::string title;
  std::string about;
  std::vector<CollectedSection> sections;
};

// The sequences that the table's problems say are not there, each once.
std::vector<std::string> MissingSequences(const Table& table);

// One page without scripts, with a table of contents; nothing from the network.
std::string CollectionHtml(const CollectedPage& page);

}  // namespace cvo::reports
