// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "reports/tables/table.h"

// A table as texts, and the formats that are written from them.
namespace cvo::reports {

// A figure to be printed, with its interval.
struct Measured {
  double value = 0.0;
  std::optional<Interval> interval;
};

// Unit of a number of events. Result files give it the unit "1", like any plain number.
inline constexpr char kCountUnit[] = "events";

// Returns the number of decimals of each figure of one column. Half the width of an interval is
// worth two significant digits. Its figure has at least two and at most four, and otherwise as many
// decimals as the figure of the column that needs most. Without an interval the unit decides.
std::vector<int> ColumnDecimals(const std::vector<Measured>& figures, const std::string& unit);

// Formats a value with a fixed number of decimals; zero has no sign.
std::string Fixed(double value, int decimals);

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

// "[a]", "[b]", ...: the mark of a source of reference rows.
std::string SourceMark(std::size_t source);

// "11 bodies, 4 scenes, 5 seeds, 20 runs": what a value is a mean over.
std::string CountsText(const Counts& n);

// "3 of 4 runs, 1 of them lost": how many there are, and what became of the others.
std::string JobsText(const JobCounts& jobs);

// What a reader must know about the numbers: which runs are missing, what intervals mean, what
// values are based on and leave out, and where the numbers of others come from.
std::vector<std::string> Footnotes(const Table& table);

// The definition of each column, from its contract.
std::vector<std::string> Definitions(const Table& table);

// Returns aligned columns with their units, then footnotes but no definitions. With `dim`, figures
// that are not comparable are dimmed by terminal codes in addition to their brackets. A table wider
// than `width` is split into several, each accuracy beside its coverage; 0: no limit.
std::string TableText(const Table& table, bool dim, std::size_t width = 0);

// The same as Markdown, with the definitions of the columns.
std::string TableMarkdown(const Table& table);

// Returns a tabular with the values and one with the differences, for \input into a document that
// uses booktabs. Notes and definitions follow as comments.
std::string TableLatex(const Table& table);

// Returns the table as CSV (RFC 4180) with all digits. There is one record per row of the table and
// per line of published figures, with value, interval and marks of each column side by side; or one
// record per cell, with everything that the table knows about it.
std::string TableCsv(const Table& table);
std::string TableLongCsv(const Table& table);

// Returns a text as a CSV field: harmless in a terminal and a spreadsheet (no formula, no control
// character but line ends), quoted if necessary.
std::string CsvField(const std::string& text);

}  // namespace cvo::reports
