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
  std::string n;                 // "11 bodies, 4 scenes, 5 seeds, 20 runs"
  std::string note;              // why there is no value, or why it is not comparable
  bool distinguishable = false;  // distinguishable from the reference
  bool grey = false;             // not comparable with the rest of its column

  // Returns the value, in brackets if it is not comparable.
  std::string Shown() const;
  bool operator==(const CellText&) const = default;
};

// One line of a table: a row of ours, or a row of published figures below it.
struct TextLine {
  const Row* row = nullptr;              // nullptr: a row of Table::others
  const ReferenceRow* theirs = nullptr;  // nullptr: a row of ours
  std::vector<std::string> texts = {};   // one per entry of the text header
  std::vector<CellText> cells = {};      // one per column
  bool grey = false;                     // nothing in it is comparable
};

struct TextBlock {
  std::string heading;
  std::vector<TextLine> lines;
};

// The texts of a table, which must outlive them, each on one line, before any layout or escaping.
// All formats show these.
struct TableTexts {
  std::string title;
  std::string about;
  std::vector<std::string> text_header;  // keys of rows, then frames and truth, split, runs
  std::vector<std::string> columns;      // "object ATE [m]"
  std::vector<TextBlock> blocks;         // values, then differences if there are any
  std::vector<std::string> footnotes;
};

TableTexts MakeTexts(const Table& table);

// The columns that tell most, at most seven in the order of the short table: of bodies, of
// landmarks and of the camera, then those that the table begins with.
std::vector<std::size_t> KeyColumns(const Table& table);

// "[a]", "[b]", ...: the mark of a source of reference rows, given by its id.
std::string SourceMark(const Table& table, const std::string& source);

// "11 bodies, 4 scenes, 5 seeds, 20 runs": what a value is a mean over.
std::string CountsText(const Counts& n);

// The jobs without a result, or with one to be read with care, and why.
std::vector<std::string> ProblemTexts(const Table& table);

// "3 of 4 runs, 1 of them lost": how many there are, and what became of the others.
std::string JobsText(const JobCounts& jobs);

// What a reader must know about the numbers: which runs are missing, what values are based on and
// leave out, what intervals mean, where the numbers of others come from, and the definition of each
// column from its contract.
std::vector<std::string> Footnotes(const Table& table);

// Returns columns of texts, aligned at the left, each made printable.
std::string AlignedText(const std::vector<std::vector<std::string>>& rows);

// What tells most: one line per row with at most six columns, and two lines of notes.
struct ShortTable {
  std::vector<std::string> headings;           // of the columns after the name of the row
  std::vector<std::vector<std::string>> rows;  // names, then cells; of results of others indented
  std::size_t more = 0;                        // rows that are left out
  std::vector<std::string> notes;
};
ShortTable MakeShortTable(const Table& table);

// Returns what tells most on one screen, 100 columns by 40 lines with the line after it.
std::string TableText(const Table& table);

// Returns all values of each row, one per line with its interval, then the differences and the
// footnotes.
std::string TableListing(const Table& table);

// The same as Markdown.
std::string TableMarkdown(const Table& table);

// Returns what tells most as Markdown, with intervals and the build: what documents quote.
std::string ShortMarkdown(const Table& table);

// Returns a tabular with the values, for \input into a document that uses booktabs. The footnotes
// follow as comments.
std::string TableLatex(const Table& table);

// Returns our rows as CSV (RFC 4180) with all digits: value, interval, marks and difference of each
// column side by side.
std::string TableCsv(const Table& table);

// Returns a text as a CSV field: harmless in a terminal and a spreadsheet (no formula, no control
// character but line ends), quoted if necessary.
std::string CsvField(const std::string& text);

}  // namespace cvo::reports
