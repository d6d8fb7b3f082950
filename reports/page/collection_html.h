// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "reports/tables/table.h"

namespace cvo::reports {

// A file stored beside the page.
struct LinkedFile {
  std::string path;  // relative to the page
  std::string caption;
};

// A section with a table or pictures, on a page about several suites.
struct CollectedSection {
  std::string title;
  std::vector<std::string> text;
  std::vector<std::string> columns;  // of a plain table of texts; empty: none
  std::vector<std::vector<std::string>> rows;
  std::optional<Table> table;
  std::string problem;               // why there is no table; empty: no problem
  std::vector<std::string> missing;  // sequences that are not on this disk
  std::string data;                  // where to get the missing sequences
  std::vector<LinkedFile> pictures;
  std::optional<LinkedFile> report;  // the suite's own page
};

struct CollectedPage {
  std::string title;
  std::string about;
  std::vector<CollectedSection> sections;
};

// The sequences that are not on this machine according to the table's problems, each once, with the
// message.
std::vector<std::string> MissingSequences(const Table& table);

// One page without scripts, with a table of contents. It loads nothing from the network.
std::string CollectionHtml(const CollectedPage& page);

}  // namespace cvo::reports
