// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <charconv>
#include <string_view>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "core/files/text/number.h"
#include "core/files/text/utf8.h"
#include "core/record/contract.h"
#include "reports/tables/table_texts.h"

namespace cvo::reports {
namespace {

bool IsNumber(const std::string& text) {
  double value = 0.0;
  const char* end = text.data() + text.size();
  return std::from_chars(text.data(), end, value).ptr == end;
}

// Spreadsheets take a text for a formula if it begins with one of these characters, some of which
// are full-width.
bool LooksLikeFormula(const std::string& text) {
  const std::vector<char32_t> characters = Characters(text);
  return !characters.empty() &&
         std::u32string_view(U"=+-@\t\r\n\uFF1D\uFF0B\uFF0D\uFF20").find(characters[0]) !=
             std::u32string_view::npos;
}

class Record {
 public:
  void Text(const std::string& text) { fields_.push_back(CsvField(text)); }
  void Names(const std::string& names) { fields_.push_back(names); }  // in CSV
  void Number(double value) { fields_.push_back(FormatDouble(value)); }
  void Number(const std::optional<double>& value) { value ? Number(*value) : Blanks(1); }
  void Count(std::size_t count) { fields_.push_back(StrCat(count)); }
  void Blanks(std::size_t count) { fields_.resize(fields_.size() + count); }
  void Ends(const std::optional<Interval>& interval) {
    if (!interval) return Blanks(2);
    Number(interval->low);
    Number(interval->high);
  }
  std::string Line() const { return Joined(fields_, ",") + "\r\n"; }

 private:
  std::vector<std::string> fields_;
};

// The published figures of a line; nullptr if it is ours.
const ReferenceRow* TheirsOf(const Table& table, const TextLine& line) {
  if (!line.reference) return nullptr;
  return line.row ? &table.rows[*line.row].reference[*line.reference]
                  : &table.others[*line.reference];
}

// The fields that begin each record of a line: whose figures they are, and of which frames.
Record HeadOf(const Table& table, const TextLine& line) {
  Record record;
  if (!line.row) record.Blanks(table.keys.size());
  if (line.row) {
    for (const std::string& key : table.rows[*line.row].keys) record.Text(key);
  }
  if (const ReferenceRow* theirs = TheirsOf(table, line)) {
    record.Text(theirs->system);
    record.Text(table.sources[theirs->source].source);
    record.Text(theirs->frames > 0 ? FrameRange(theirs->first_frame, theirs->frames) : "");
    record.Blanks(4);
    return record;
  }
  const Row& row = table.rows[*line.row];
  record.Blanks(2);
  record.Text(row.sequence ? FrameRange(row.sequence->first_frame, row.sequence->frames) : "");
  record.Text(TruthText(row.truth));
  record.Text(row.split);
  record.Count(row.jobs.done);
  record.Count(row.jobs.planned);
  return record;
}

// The header of all records, with the names of the fields that follow their heads.
std::string HeaderLine(const Table& table, const std::string& names) {
  Record keys;
  for (const std::string& key : table.keys) keys.Text(key);
  keys.Names("system,source,frames,truth,split,runs_done,runs_planned" + names);
  return keys.Line();
}

std::string Marks(const CellText& cell) {
  std::vector<std::string> marks;
  if (cell.best) marks.emplace_back("best");
  if (cell.distinguishable) marks.emplace_back("distinguishable");
  if (cell.grey) marks.emplace_back("not comparable");
  if (cell.value == "-") marks.emplace_back("missing");
  return Joined(marks, " ");
}

// Value, low, high, n, marks and note.
void AddWideCell(const Table& table, const TextLine& line, std::size_t column, Record& record) {
  const CellText& text = line.cells[column];
  if (const ReferenceRow* theirs = TheirsOf(table, line)) {
    const auto& cell = theirs->cells[column];
    record.Number(cell ? std::optional(cell->value) : std::nullopt);
    record.Blanks(3);
  } else {
    const Cell& cell = table.rows[*line.row].cells[column];
    record.Number(cell.present ? std::optional(cell.value) : std::nullopt);
    record.Ends(cell.interval);
    record.Text(text.n);
  }
  record.Text(Marks(text));
  record.Text(text.note);
}

constexpr std::size_t kDifferenceFields = 9;

void AddDifference(const std::optional<Difference>& difference, Record& record) {
  if (!difference) return record.Blanks(kDifferenceFields);
  record.Text(difference->reference);
  record.Number(difference->difference);
  record.Ends(difference->interval);
  record.Count(difference->pairs);
  record.Number(difference->p_value);
  record.Number(difference->adjusted_p_value);
  record.Text(difference->scenes_for_10_percent ? StrCat(*difference->scenes_for_10_percent) : "");
  record.Text(difference->distinguishable ? "true" : "false");
}

// The value, what it is a mean over, and the coverage that it must be read with.
void AddValue(const Row& row, std::size_t column, const std::optional<std::size_t>& coverage,
              Record& record) {
  const Cell& cell = row.cells[column];
  record.Number(cell.present ? std::optional(cell.value) : std::nullopt);
  record.Ends(cell.interval);
  record.Text(cell.interval ? cell.interval->meaning : "");
  if (!cell.present) record.Blanks(4);
  for (const std::size_t count : {cell.n.runs, cell.n.scenes, cell.n.bodies, cell.n.seeds}) {
    if (cell.present) record.Count(count);
  }
  const bool covered = coverage && row.cells[*coverage].present;
  record.Number(covered ? std::optional(row.cells[*coverage].value) : std::nullopt);
}

std::string LongRecord(const Table& table, const TableTexts& texts, const TextLine& line,
                       std::size_t column) {
  const CellText& text = line.cells[column];
  Record record = HeadOf(table, line);
  record.Text(table.columns[column].metric);
  record.Text(table.columns[column].unit);
  if (const ReferenceRow* theirs = TheirsOf(table, line)) {
    const ReferenceCell& cell = *theirs->cells[column];
    record.Number(cell.value);
    record.Blanks(7 + 1 + kDifferenceFields + 1);
    record.Text(Marks(text));
    record.Blanks(2);
    record.Text(NameOf(cell.match));
    record.Text(text.note);
    return record.Line();
  }
  const Row& row = table.rows[*line.row];
  const Cell& cell = row.cells[column];
  AddValue(row, column, texts.columns[column].coverage, record);
  AddDifference(cell.difference, record);
  record.Text(cell.left_out);
  record.Text(Marks(text));
  record.Text(cell.not_comparable);
  record.Text(cell.message);
  record.Blanks(2);
  return record.Line();
}

}  // namespace

std::string CsvField(const std::string& text) {
  if (IsNumber(text)) return text;
  const std::string field = (LooksLikeFormula(text) ? "'" : "") + PrintableLines(text);
  const bool blank_ends = !field.empty() && (field.front() == ' ' || field.back() == ' ');
  if (!blank_ends && field.find_first_of(",;\"\n") == std::string::npos) return field;
  std::string quoted = "\"";
  for (const char c : field) quoted += c == '"' ? std::string(2, c) : std::string(1, c);
  return quoted + "\"";
}

std::string TableCsv(const Table& table) {
  const TableTexts texts = MakeTexts(table);
  std::string names;
  for (const Column& column : table.columns) {
    const std::string unit = column.unit == "1" ? "" : StrCat(" [", column.unit, "]");
    names += "," + CsvField(column.metric + unit);
    for (const char* what : {" low", " high", " n", " marks", " note"}) {
      names += "," + CsvField(column.metric + what);
    }
  }
  std::string csv = HeaderLine(table, names);
  for (const TextLine& line : texts.blocks[0].lines) {
    Record record = HeadOf(table, line);
    for (std::size_t i = 0; i < table.columns.size(); ++i) AddWideCell(table, line, i, record);
    csv += record.Line();
  }
  return csv;
}

std::string TableLongCsv(const Table& table) {
  const TableTexts texts = MakeTexts(table);
  std::string csv = HeaderLine(
      table,
      ",metric,unit,value,low,high,interval,runs,scenes,bodies,seeds,coverage,reference,difference,"
      "difference_low,difference_high,pairs,p_value,adjusted_p_value,scenes_for_10_percent,"
      "distinguishable,left_out,marks,not_comparable,message,comparison,comparison_reason");
  for (const TextLine& line : texts.blocks[0].lines) {
    const ReferenceRow* theirs = TheirsOf(table, line);
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
      if (theirs == nullptr || theirs->cells[i]) csv += LongRecord(table, texts, line, i);
    }
  }
  return csv;
}

}  // namespace cvo::reports
