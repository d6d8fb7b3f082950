// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <array>
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
  void Number(const std::optional<double>& value) {
    fields_.push_back(value ? FormatDouble(*value) : "");
  }
  void Count(std::size_t count) { fields_.push_back(StrCat(count)); }
  void Ends(const std::optional<Interval>& interval) {
    Number(interval ? std::optional(interval->low) : std::nullopt);
    Number(interval ? std::optional(interval->high) : std::nullopt);
  }
  void Blanks(std::size_t count) { fields_.resize(fields_.size() + count); }
  std::string Line() const { return Joined(fields_, ",") + "\r\n"; }

 private:
  std::vector<std::string> fields_;
};

// The fields that begin each record of a line: whose figures they are, and of which frames.
Record HeadOf(const Table& table, const TextLine& line) {
  Record record;
  for (std::size_t i = 0; i < table.keys.size(); ++i) {
    record.Text(line.row != nullptr ? line.row->keys[i] : "");
  }
  if (const ReferenceRow* theirs = line.theirs) {
    record.Text(theirs->system);
    record.Text(FindBy(table.sources, &ReferenceSource::id, theirs->source)->source);
    record.Text(theirs->frames > 0 ? FrameRange(theirs->first_frame, theirs->frames) : "");
    record.Blanks(4);
    return record;
  }
  const Row& row = *line.row;
  record.Blanks(2);
  record.Text(row.sequence ? FrameRange(row.sequence->first_frame, row.sequence->frames) : "");
  record.Text(TruthText(row.truth));
  record.Text(row.split);
  record.Count(row.jobs.done);
  record.Count(row.jobs.planned);
  return record;
}

std::string Marks(const CellText& cell) {
  std::vector<std::string> marks;
  if (cell.distinguishable) marks.emplace_back("distinguishable");
  if (cell.grey) marks.emplace_back("not comparable");
  if (cell.value == "-") marks.emplace_back("missing");
  return Joined(marks, " ");
}

constexpr std::array kFields = {" low", " high", " n", " marks", " note"};
constexpr std::array kDifferenceFields = {" difference", " difference low", " difference high",
                                          " adjusted p"};

// The value and kFields.
void AddCell(const TextLine& line, const ReferenceCell* theirs, std::size_t column,
             Record& record) {
  const CellText& text = line.cells[column];
  if (line.theirs != nullptr) {
    record.Number(theirs != nullptr ? std::optional(theirs->value) : std::nullopt);
    record.Blanks(3);
  } else {
    record.Number(line.row->cells[column].value);
    record.Ends(line.row->cells[column].interval);
    record.Text(text.n);
  }
  record.Text(Marks(text));
  record.Text(text.note);
}

void AddDifference(const TextLine& line, std::size_t column, Record& record) {
  if (line.theirs != nullptr || !line.row->cells[column].difference) {
    return record.Blanks(kDifferenceFields.size());
  }
  const Difference& difference = *line.row->cells[column].difference;
  record.Number(difference.difference);
  record.Ends(difference.interval);
  record.Number(difference.adjusted_p_value);
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
  Record header;
  for (const std::string& key : table.keys) header.Text(key);
  for (const char* name :
       {"system", "source", "frames", "truth", "split", "runs_done", "runs_planned"}) {
    header.Text(name);
  }
  for (const Column& column : table.columns) {
    header.Text(column.metric + (column.unit == "1" ? "" : StrCat(" [", column.unit, "]")));
    for (const char* what : kFields) header.Text(column.metric + what);
    if (table.reference.empty()) continue;
    for (const char* what : kDifferenceFields) header.Text(column.metric + what);
  }
  std::string csv = header.Line();
  for (const TextLine& line : texts.blocks[0].lines) {
    Record record = HeadOf(table, line);
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
      AddCell(line, line.theirs ? line.theirs->Find(table.columns[i]) : nullptr, i, record);
      if (!table.reference.empty()) AddDifference(line, i, record);
    }
    csv += record.Line();
  }
  return csv;
}

}  // namespace cvo::reports
