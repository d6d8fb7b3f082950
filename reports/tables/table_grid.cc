// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/tables/table_grid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "core/base/error.h"
#include "reports/tables/footnotes.h"

namespace cvo::reports {
namespace {

using GridRow = std::vector<GridCell>;

std::string Printed(double value, const char* format) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), format, value);
  return text.data();
}

std::string Value(double value, const std::string& unit) {
  if (unit == "m" || unit == "rad") {
    return Printed(value, std::abs(value) < 0.01 && value != 0.0 ? "%.5f" : "%.4f");
  }
  if (unit == "%") return Printed(value, "%.2f");
  return Printed(value, unit == "1" ? "%.3f" : "%.4g");
}

std::string Signed(double value, const std::string& unit) {
  return StrCat(value < 0.0 ? "" : "+", Value(value, unit));
}

std::string RangeText(const Interval& interval, const std::string& unit) {
  return Value(interval.low, unit) + ".." + Value(interval.high, unit);
}

std::string FrameRange(int first, int count) { return StrCat(first, ":", first + count); }

bool ShowsSequences(const Table& table) {
  return std::find(table.keys.begin(), table.keys.end(), "sequence") != table.keys.end();
}

std::vector<std::string> TextHeader(const Table& table) {
  std::vector<std::string> header = table.keys;
  if (ShowsSequences(table)) header.insert(header.end(), {"frames", "truth"});
  header.emplace_back("runs");
  return header;
}

// What of the truth goes into a cell: its name, without what counts as visible.
std::string ShortTruth(const std::string& truth) {
  return truth.empty() ? "-" : truth.substr(0, truth.find(';'));
}

GridRow RowTexts(const Row& row, const Table& table) {
  GridRow texts;
  for (const std::string& key : row.keys) texts.push_back({key});
  if (ShowsSequences(table)) {
    texts.push_back(
        {row.sequence ? FrameRange(row.sequence->first_frame, row.sequence->frames) : "-"});
    texts.push_back({ShortTruth(row.truth)});
  }
  texts.push_back({StrCat(row.jobs.done, "/", row.jobs.planned)});
  return texts;
}

void AddValues(const Row& row, const Table& table, GridBlock& block) {
  GridRow values = RowTexts(row, table);
  GridRow intervals(values.size());
  bool any = false;
  for (std::size_t i = 0; i < row.cells.size(); ++i) {
    const Cell& cell = row.cells[i];
    const std::string& unit = table.columns[i].unit;
    const bool marked = cell.difference && cell.difference->distinguishable;
    values.push_back({cell.present ? StrCat(Value(cell.value, unit), marked ? "*" : "") : "-",
                      !cell.not_comparable.empty()});
    intervals.push_back({cell.interval ? RangeText(*cell.interval, unit) : ""});
    any = any || cell.interval;
  }
  block.rows.push_back(std::move(values));
  if (any) block.rows.push_back(std::move(intervals));
}

GridRow TheirRow(const ReferenceRow& line, const Table& table) {
  GridRow cells(TextHeader(table).size());
  const auto variant = std::find(table.keys.begin(), table.keys.end(), "variant");
  const auto at = variant == table.keys.end() ? 0 : variant - table.keys.begin();
  cells[static_cast<std::size_t>(at)].text = line.system + " " + SourceMark(line.source);
  if (line.frames > 0 && ShowsSequences(table)) {
    cells[table.keys.size()].text = FrameRange(line.first_frame, line.frames);
  }
  const std::size_t texts = cells.size();
  bool any_match = false;
  for (const auto& cell : line.cells) {
    const bool match = cell && cell->match == Match::kMatches;
    any_match = any_match || match;
    cells.push_back({cell ? Printed(cell->value, "%.6g") : "", cell && !match});
  }
  for (std::size_t i = 0; i < texts; ++i) cells[i].grey = !any_match && !cells[i].text.empty();
  return cells;
}

std::string PercentRangeText(const Interval& interval) {
  return Printed(interval.low, "%.0f..") + Printed(interval.high, "%.0f%%");
}

// Difference, its interval, percent, its interval: four lines.
std::array<std::string, 4> DifferenceTexts(const Difference& difference, const std::string& unit,
                                           bool change) {
  const auto& percent = change ? difference.percent : difference.reference_lower;
  const auto& range = change ? difference.percent_interval : difference.reference_lower_interval;
  return {StrCat(Signed(difference.difference, unit), difference.distinguishable ? "*" : ""),
          difference.interval ? RangeText(*difference.interval, unit) : "",
          percent ? Printed(*percent, change ? "%+.1f%%" : "%.1f%%") : "",
          range ? PercentRangeText(*range) : ""};
}

void AddDifferences(const Row& row, const Table& table, GridBlock& block) {
  std::array<GridRow, 4> lines;
  lines[0] = RowTexts(row, table);
  for (GridRow& line : lines) line.resize(lines[0].size());
  bool any = false;
  for (std::size_t i = 0; i < row.cells.size(); ++i) {
    const auto& difference = row.cells[i].difference;
    std::array<std::string, 4> texts;
    if (difference) texts = DifferenceTexts(*difference, table.columns[i].unit, table.change);
    for (std::size_t line = 0; line < texts.size(); ++line) lines[line].push_back({texts[line]});
    any = any || difference;
  }
  if (any) block.rows.insert(block.rows.end(), lines.begin(), lines.end());
}

}  // namespace

Grid MakeGrid(const Table& table) {
  Grid grid;
  grid.header = TextHeader(table);
  grid.text_columns = grid.header.size();
  for (const Column& column : table.columns) {
    grid.header.push_back(column.unit == "1" ? column.label
                                             : StrCat(column.label, " [", column.unit, "]"));
  }
  GridBlock values;
  GridBlock differences;
  for (const Row& row : table.rows) {
    AddValues(row, table, values);
    for (const ReferenceRow& line : row.reference) values.rows.push_back(TheirRow(line, table));
    AddDifferences(row, table, differences);
  }
  for (const ReferenceRow& line : table.others) values.rows.push_back(TheirRow(line, table));
  grid.blocks.push_back(std::move(values));
  if (!differences.rows.empty()) {
    differences.heading =
        StrCat("difference to ", table.reference, ", paired, with its interval; below, ",
               table.change ? "in percent of what was"
                            : StrCat("by how many percent ", table.reference, " is lower"));
    grid.blocks.push_back(std::move(differences));
  }
  grid.footnotes = Footnotes(table);
  grid.definitions = Definitions(table);
  return grid;
}

}  // namespace cvo::reports
