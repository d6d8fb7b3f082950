// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/formats/table_csv.h"

#include "core/base/error.h"
#include "core/files/text/number.h"
#include "reports/formats/csv_text.h"
#include "reports/formats/digits.h"
#include "reports/formats/table_texts.h"
#include "reports/results/contract_text.h"

namespace cvo::reports {
namespace {

using Record = std::vector<std::string>;

void AddText(const std::string& text, Record& record) { record.push_back(CsvField(text)); }

void AddNumber(const std::optional<double>& value, Record& record) {
  record.push_back(value ? FormatDouble(*value) : "");
}

void AddCount(std::size_t count, Record& record) { record.push_back(StrCat(count)); }

void AddBlanks(std::size_t count, Record& record) { record.resize(record.size() + count); }

std::optional<double> Low(const std::optional<Interval>& interval) {
  return interval ? std::optional(interval->low) : std::nullopt;
}

std::optional<double> High(const std::optional<Interval>& interval) {
  return interval ? std::optional(interval->high) : std::nullopt;
}

const ReferenceRow& FindReferenceRow(const Table& table, const TextLine& line) {
  return line.row ? table.rows[*line.row].reference[*line.reference]
                  : table.others[*line.reference];
}

// Appends the fields that begin each record of a line: whose figures they are, and of which frames.
void AddHead(const Table& table, const TextLine& line, Record& record) {
  if (line.row) {
    for (const std::string& key : table.rows[*line.row].keys) AddText(key, record);
  } else {
    AddBlanks(table.keys.size(), record);
  }
  if (line.reference) {
    const ReferenceRow& theirs = FindReferenceRow(table, line);
    AddText(theirs.system, record);
    AddText(table.sources[theirs.source].source, record);
    AddText(theirs.frames > 0 ? StrCat(theirs.first_frame, ":", theirs.first_frame + theirs.frames)
                              : "",
            record);
    AddBlanks(4, record);
    return;
  }
  const Row& row = table.rows[*line.row];
  AddBlanks(2, record);
  AddText(row.sequence ? StrCat(row.sequence->first_frame, ":",
                                row.sequence->first_frame + row.sequence->frames)
                       : "",
          record);
  AddText(TruthText(row.truth), record);
  AddText(row.split, record);
  AddCount(row.jobs.done, record);
  AddCount(row.jobs.planned, record);
}

Record HeadNames(const Table& table) {
  Record names;
  for (const std::string& key : table.keys) AddText(key, names);
  for (const char* name :
       {"system", "source", "frames", "truth", "split", "runs_done", "runs_planned"}) {
    names.emplace_back(name);
  }
  return names;
}

std::string Marks(const CellText& cell) {
  std::string marks;
  const auto add = [&marks](bool marked, const char* word) {
    if (marked) marks += StrCat(marks.empty() ? "" : " ", word);
  };
  add(cell.best, "best");
  add(cell.distinguishable, "distinguishable");
  add(cell.grey, "not comparable");
  add(cell.value == "-", "missing");
  return marks;
}

// Appends value, low, high, n, marks and note of one cell.
void AddWideCell(const Table& table, const TextLine& line, std::size_t column, Record& record) {
  if (line.reference) {
    const auto& cell = FindReferenceRow(table, line).cells[column];
    AddNumber(cell ? std::optional(cell->value) : std::nullopt, record);
    AddBlanks(3, record);
  } else {
    const Cell& cell = table.rows[*line.row].cells[column];
    AddNumber(cell.present ? std::optional(cell.value) : std::nullopt, record);
    AddNumber(Low(cell.interval), record);
    AddNumber(High(cell.interval), record);
    AddText(line.cells[column].n, record);
  }
  AddText(Marks(line.cells[column]), record);
  AddText(line.cells[column].note, record);
}

void AddResultCell(const Cell& cell, Record& record) {
  AddNumber(cell.present ? std::optional(cell.value) : std::nullopt, record);
  AddNumber(Low(cell.interval), record);
  AddNumber(High(cell.interval), record);
  AddText(cell.interval ? cell.interval->meaning : "", record);
  for (const std::size_t count : {cell.n.runs, cell.n.scenes, cell.n.bodies, cell.n.seeds}) {
    if (cell.present) AddCount(count, record);
  }
  if (!cell.present) AddBlanks(4, record);
}

constexpr std::size_t kDifferenceFields = 9;

void AddDifference(const std::optional<Difference>& difference, Record& record) {
  if (!difference) return AddBlanks(kDifferenceFields, record);
  AddText(difference->reference, record);
  AddNumber(difference->difference, record);
  AddNumber(Low(difference->interval), record);
  AddNumber(High(difference->interval), record);
  AddCount(difference->pairs, record);
  AddNumber(difference->p_value, record);
  AddNumber(difference->adjusted_p_value, record);
  record.push_back(difference->scenes_for_10_percent ? StrCat(*difference->scenes_for_10_percent)
                                                     : "");
  record.emplace_back(difference->distinguishable ? "true" : "false");
}

// Appends the coverage that the cell must be read with.
void AddCoverage(const Table& table, const TableTexts& texts, const TextLine& line,
                 std::size_t column, Record& record) {
  const auto coverage = texts.columns[column].coverage;
  if (!coverage || line.reference || !table.rows[*line.row].cells[*coverage].present) {
    return AddBlanks(1, record);
  }
  AddNumber(table.rows[*line.row].cells[*coverage].value, record);
}

std::string LongRecord(const Table& table, const TableTexts& texts, const TextLine& line,
                       std::size_t column) {
  Record record;
  AddHead(table, line, record);
  AddText(table.columns[column].metric, record);
  AddText(table.columns[column].unit, record);
  if (line.reference) {
    const ReferenceCell& cell = *FindReferenceRow(table, line).cells[column];
    AddNumber(cell.value, record);
    AddBlanks(7 + 1 + kDifferenceFields + 1, record);
    AddText(Marks(line.cells[column]), record);
    AddBlanks(2, record);
    AddText(NameOf(cell.match), record);
    AddText(line.cells[column].note, record);
    return CsvRecord(record);
  }
  const Cell& cell = table.rows[*line.row].cells[column];
  AddResultCell(cell, record);
  AddCoverage(table, texts, line, column, record);
  AddDifference(cell.difference, record);
  AddText(cell.left_out, record);
  AddText(Marks(line.cells[column]), record);
  AddText(cell.not_comparable, record);
  AddText(cell.message, record);
  AddBlanks(2, record);
  return CsvRecord(record);
}

}  // namespace

std::string TableCsv(const Table& table) {
  const TableTexts texts = MakeTexts(table);
  Record header = HeadNames(table);
  for (const Column& column : table.columns) {
    AddText(column.unit == "1" ? column.metric : StrCat(column.metric, " [", column.unit, "]"),
            header);
    for (const char* what : {" low", " high", " n", " marks", " note"}) {
      AddText(column.metric + what, header);
    }
  }
  std::string csv = CsvRecord(header);
  for (const TextLine& line : texts.blocks[0].lines) {
    Record record;
    AddHead(table, line, record);
    for (std::size_t i = 0; i < table.columns.size(); ++i) AddWideCell(table, line, i, record);
    csv += CsvRecord(record);
  }
  return csv;
}

std::string TableLongCsv(const Table& table) {
  const TableTexts texts = MakeTexts(table);
  Record header = HeadNames(table);
  for (const char* name : {"metric",
                           "unit",
                           "value",
                           "low",
                           "high",
                           "interval",
                           "runs",
                           "scenes",
                           "bodies",
                           "seeds",
                           "coverage",
                           "reference",
                           "difference",
                           "difference_low",
                           "difference_high",
                           "pairs",
                           "p_value",
                           "adjusted_p_value",
                           "scenes_for_10_percent",
                           "distinguishable",
                           "left_out",
                           "marks",
                           "not_comparable",
                           "message",
                           "comparison",
                           "comparison_reason"}) {
    header.emplace_back(name);
  }
  std::string csv = CsvRecord(header);
  for (const TextLine& line : texts.blocks[0].lines) {
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
      if (line.reference && !FindReferenceRow(table, line).cells[i]) continue;
      csv += LongRecord(table, texts, line, i);
    }
  }
  return csv;
}

}  // namespace cvo::reports
