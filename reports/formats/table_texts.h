// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "reports/tables/table.h"

namespace cvo::reports {

struct CellText {
  std::string value;             // "-": a value is missing; empty: none is expected
  std::string interval;          // "low..high"
  std::string percent;           // of a difference
  std::string percent_interval;  // of a difference
  std::string n;                 // "11 bodies, 4 scenes, 5 seeds, 20 runs"
  std::string units;             // the units that the interval resamples: "4 scenes"
  std::string note;              // why there is no value, or why it is not comparable
  bool best = false;             // best of its column among rows on the same data
  bool distinguishable = false;  // distinguishable from the reference
  bool grey = false;             // not comparable with the rest of its column

  // Returns the value, in brackets if it is not comparable.
  std::string Shown() const;
  bool operator==(const CellText&) const = default;
};

// One line of a table: a row of ours, or a row of published figures below it.
struct TextLine {
  std::optional<std::size_t> row;        // index in Table::rows; empty: a row of Table::others
  std::optional<std::size_t> reference;  // index in Row::reference or Table::others; empty: ours
  std::vector<std::string> texts;        // one per entry of the text header
  std::vector<CellText> cells;           // one per column
  bool grey = false;                     // nothing in it is comparable
};

struct TextBlock {
  std::string heading;
  std::vector<TextLine> lines;
};

struct ColumnText {
  std::string label;
  std::string unit;                     // empty: a plain number
  std::optional<std::size_t> coverage;  // the column that it must be read with, if it is another

  // "object ATE [m]"
  std::string Heading() const;
};

// The texts of a table, each on one line, before any layout or escaping. All formats show these.
struct TableTexts {
  std::string title;
  std::string about;
  std::vector<std::string> text_header;  // keys of rows, then frames and truth, split, runs
  std::vector<ColumnText> columns;
  std::vector<TextBlock> blocks;  // values, then differences if there are any
  bool any_best = false;
  std::vector<std::string> footnotes;
  std::vector<std::string> definitions;  // of the columns, from their contracts
};

TableTexts MakeTexts(const Table& table);

// Returns the meaning of the mark of best cells, such as "^: best value of the column ...".
std::string BestNote(const std::string& mark);

}  // namespace cvo::reports
