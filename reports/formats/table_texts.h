// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "reports/tables/table.h"

namespace cvo::reports {

struct CellText {
  std::string value;             // "-": there should be one; empty: nothing to say
  std::string interval;          // "low..high"
  std::string percent;           // of a difference
  std::string percent_interval;  // of a difference
  std::string n;                 // "11 bodies, 4 scenes, 5 seeds, 20 runs"
  std::string units;             // of these, what the interval resamples: "4 scenes"
  std::string note;              // why there is no value, or why it does not compare
  bool best = false;             // of its column, among rows on the same data
  bool distinguishable = false;  // from the reference
  bool grey = false;             // does not compare with the others of its column

  // The value, in brackets where it does not compare.
  std::string Shown() const;
  bool operator==(const CellText&) const = default;
};

// One line of a table: a row of ours, or a figure of others below it.
struct TextLine {
  std::optional<std::size_t> row;        // in Table::rows; empty: of Table::others
  std::optional<std::size_t> reference;  // in Row::reference or Table::others; empty: a row of ours
  std::vector<std::string> texts;        // as many as the text header
  std::vector<CellText> cells;           // one per column
  bool grey = false;                     // nothing in it compares
};

struct TextBlock {
  std::string heading;
  std::vector<TextLine> lines;
};

struct ColumnText {
  std::string label;
  std::string unit;                     // empty: a plain number
  std::optional<std::size_t> coverage;  // the column that it must be read with, where it is another

  // "object ATE [m]"
  std::string Heading() const;
};

// A table in words, each on one line, before any layout or escaping: what every rendering shows.
struct TableTexts {
  std::string title;
  std::string about;
  std::vector<std::string> text_header;  // keys of rows, then frames and truth, split, runs
  std::vector<ColumnText> columns;
  std::vector<TextBlock> blocks;  // values, then differences where there are any
  bool any_best = false;
  std::vector<std::string> footnotes;
  std::vector<std::string> definitions;  // of the columns, by their contracts
};

TableTexts MakeTexts(const Table& table);

// What a mark of best cells means, such as "^: best value of the column ...".
std::string BestNote(const std::string& mark);

}  // namespace cvo::reports
