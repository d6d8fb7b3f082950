// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/tables/table_grid.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <map>

#include "core/base/error.h"

namespace cvo::reports {
namespace {

constexpr std::size_t kTextColumns = 4;

std::string WithDecimals(double value, const char* format) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), format, value);
  return text.data();
}

std::string OurValue(double value, const std::string& unit) {
  if (unit == "rad") return WithDecimals(value, "%.4f");
  if (unit == "%") return WithDecimals(value, "%.2f");
  return WithDecimals(value, unit == "m" || unit == "1" ? "%.3f" : "%.4g");
}

std::string FrameRange(int first, int count) { return StrCat(first, ":", first + count); }

std::string Mark(std::size_t source) {
  return StrCat("[", static_cast<char>('a' + static_cast<int>(source % 26)), "]");
}

std::vector<GridCell> OurRow(const Row& row, const Table& table) {
  const bool read = !row.links.empty();
  std::string system = read ? row.variant : row.status;
  if (read && row.status != "ok") system += " (" + row.status + ")";
  std::vector<GridCell> cells = {
      {row.sequence.name},
      {read ? FrameRange(row.sequence.first_frame, row.sequence.frames) : "-"},
      {row.truth.empty() ? "-" : row.truth},
      {system}};
  for (std::size_t i = 0; i < row.cells.size(); ++i) {
    cells.push_back(
        {row.cells[i].present ? OurValue(row.cells[i].value, table.columns[i].unit) : "-"});
  }
  return cells;
}

std::vector<GridCell> TheirRow(const ReferenceRow& line) {
  std::vector<GridCell> cells = {{""},
                                 {FrameRange(line.first_frame, line.frames)},
                                 {""},
                                 {line.system + " " + Mark(line.source)}};
  bool any_match = false;
  for (const auto& cell : line.cells) {
    const bool match = cell && cell->match == Match::kMatches;
    any_match = any_match || match;
    cells.push_back({cell ? WithDecimals(cell->value, "%.6g") : "", cell && !match});
  }
  for (std::size_t i = 0; i < kTextColumns; ++i)
    cells[i].grey = !any_match && !cells[i].text.empty();
  return cells;
}

// Each different reason why figures of a source do not compare, or what was inferred of them.
std::vector<std::string> Reasons(const Table& table, std::size_t source) {
  std::vector<std::string> reasons;
  for (const Row& row : table.rows) {
    for (const ReferenceRow& line : row.reference) {
      if (line.source != source) continue;
      for (std::size_t i = 0; i < line.cells.size(); ++i) {
        const auto& cell = line.cells[i];
        if (!cell || cell->reason.empty() || cell->match == Match::kOtherFrames) continue;
        const std::string reason = table.columns[i].label + " " + cell->reason;
        if (std::find(reasons.begin(), reasons.end(), reason) == reasons.end()) {
          reasons.push_back(reason);
        }
      }
    }
  }
  return reasons;
}

void AddReferenceNotes(const Table& table, std::vector<std::string>& footnotes) {
  if (table.sources.empty()) return;
  footnotes.emplace_back(
      "(in brackets): not comparable with ours: other frames or images, or a metric that differs "
      "or that the source does not define");
  for (std::size_t i = 0; i < table.sources.size(); ++i) {
    std::string note = Mark(i) + " " + table.sources[i].source;
    if (!table.sources[i].caveat.empty()) note += "; " + table.sources[i].caveat;
    for (const std::string& reason : Reasons(table, i)) note += "; " + reason;
    footnotes.push_back(note);
  }
}

void AddColumnNotes(const Table& table, std::vector<std::string>& footnotes) {
  for (const Column& column : table.columns) {
    std::string note = column.label + ":";
    for (const char* field : {"aggregation", "pairing", "delta", "alignment", "poses", "frame"}) {
      const auto found = column.contract.find(field);
      if (found == column.contract.end() || found->second.empty()) continue;
      if (found->second == "none") continue;
      note += StrCat(note.back() == ':' ? " " : "; ", field == std::string("poses") ? "poses " : "",
                     field == std::string("delta") ? "delta " : "",
                     field == std::string("alignment") ? "alignment " : "", found->second);
    }
    footnotes.push_back(note);
  }
}

// Intervals one by one; what is missing once per reason, with the columns it is about.
void AddCellNotes(const Row& row, const std::vector<Column>& columns,
                  std::vector<std::string>& footnotes) {
  std::map<std::string, std::string> missing;
  for (std::size_t i = 0; i < row.cells.size(); ++i) {
    const Cell& cell = row.cells[i];
    const Column& column = columns[i];
    if (!cell.present) {
      std::string& labels = missing[cell.message];
      labels += (labels.empty() ? "" : ", ") + column.label;
    } else if (cell.interval) {
      footnotes.push_back(StrCat(
          row.sequence.name, ", ", column.label, ": ", OurValue(cell.interval->low, column.unit),
          " to ", OurValue(cell.interval->high, column.unit), " (", cell.interval->meaning, ")"));
    }
  }
  for (const auto& [message, labels] : missing) {
    footnotes.push_back(StrCat(row.sequence.name, ": ", message, ": ", labels));
  }
}

void AddRowNotes(const Table& table, std::vector<std::string>& footnotes) {
  for (const Row& row : table.rows) {
    if (!row.message.empty()) footnotes.push_back(row.sequence.name + ": " + row.message);
    if (!row.links.empty()) AddCellNotes(row, table.columns, footnotes);
  }
}

}  // namespace

Grid MakeGrid(const Table& table) {
  Grid grid;
  grid.text_columns = kTextColumns;
  grid.header = {"sequence", "frames", "truth", "system"};
  for (const Column& column : table.columns) {
    grid.header.push_back(column.unit == "1" ? column.label
                                             : StrCat(column.label, " [", column.unit, "]"));
  }
  for (const Row& row : table.rows) {
    grid.rows.push_back(OurRow(row, table));
    for (const ReferenceRow& line : row.reference) grid.rows.push_back(TheirRow(line));
  }
  AddRowNotes(table, grid.footnotes);
  for (const std::string& note : table.notes) grid.footnotes.push_back(note);
  AddReferenceNotes(table, grid.footnotes);
  AddColumnNotes(table, grid.footnotes);
  return grid;
}

}  // namespace cvo::reports
