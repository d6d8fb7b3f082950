// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace cvo {

// A picture of a page: frames of runs of one sequence, side by side where there are several
// variants.
struct CollectionFigure {
  std::string suite;  // of the collection
  std::string sequence;
  std::string variants;  // "2d,full"
  std::vector<int> frames;
};

// A table or figure of a page: text, then the table of a suite, or figures of others with our speed
// beside, then pictures.
struct CollectionSection {
  std::string title;
  std::string suite;              // shipped, or a file; empty: none
  std::vector<std::string> text;  // what the paper has, what ours is, what differs
  std::string data;               // where to get what is missing
  std::vector<std::string> columns;
  std::vector<std::vector<std::string>> rows;  // of others, as published
  // Variants whose measured frames per second go below, with the cells before it.
  std::vector<std::pair<std::string, std::vector<std::string>>> measured;
  std::vector<CollectionFigure> figures;
  bool times = false;  // the suite's times in place of its table
};

// Suites that are run one after the other and shown on one page.
struct Collection {
  std::string name;
  std::string about;
  std::vector<CollectionSection> sections;
};

// Names of those that come with the program.
std::vector<std::string> CollectionNames();

// A shipped collection, or a JSON file with "sections"; empty for any other name or file. Throws
// Error where it is wrong.
std::optional<Collection> FindCollection(const std::string& name);

// The folder of a section's results below that of the collection.
std::string SuiteFolderName(const std::string& suite);

}  // namespace cvo
