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

using Fields = std::vector<std::string>;

void AddNumber(const std::optional<double>& value, Fields& fields) {
  fields.push_back(value ? FormatDouble(*value) : "");
}

void AddEnds(const std::optional<Interval>& interval, Fields& fields) {
  fields.push_back(interval ? FormatDouble(interval->low) : "");
  fields.push_back(interval ? FormatDouble(interval->high) : "");
}

constexpr std::array kHead = {"frames", "truth", "split", "runs_done", "runs_planned"};
constexpr std::array kFields = {" low", " high", " n", " marks", " note"};
constexpr std::array kDifferenceFields = {" difference", " difference low", " difference high",
                                          " adjusted p"};

// The value and kFields.
void AddCell(const Cell& cell, const CellText& text, Fields& fields) {
  AddNumber(cell.value, fields);
  AddEnds(cell.interval, fields);
  fields.push_back(CsvField(text.n));
  Fields marks;
  if (text.distinguishable) marks.emplace_back("distinguishable");
  if (text.grey) marks.emplace_back("not comparable");
  if (!cell.value) marks.emplace_back("missing");
  fields.push_back(Joined(marks, " "));
  fields.push_back(CsvField(text.note));
}

void AddDifference(const std::optional<Difference>& difference, Fields& fields) {
  if (!difference) return fields.resize(fields.size() + kDifferenceFields.size());
  AddNumber(difference->difference, fields);
  AddEnds(difference->interval, fields);
  AddNumber(difference->adjusted_p_value, fields);
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
  Fields header;
  for (const std::string& key : table.keys) header.push_back(CsvField(key));
  header.insert(header.end(), kHead.begin(), kHead.end());
  for (const Column& column : table.columns) {
    header.push_back(
        CsvField(column.metric + (column.unit == "1" ? "" : StrCat(" [", column.unit, "]"))));
    for (const char* what : kFields) header.push_back(CsvField(column.metric + what));
    if (table.reference.empty()) continue;
    for (const char* what : kDifferenceFields) header.push_back(CsvField(column.metric + what));
  }
  std::string csv = Joined(header, ",") + "\r\n";
  for (const TextLine& line : texts.blocks[0].lines) {
    if (line.theirs != nullptr) continue;
    const Row& row = *line.row;
    Fields fields;
    for (const std::string& key : row.keys) fields.push_back(CsvField(key));
    fields.push_back(row.sequence ? FrameRange(row.sequence->first_frame, row.sequence->frames)
                                  : "");
    fields.insert(fields.end(), {CsvField(TruthText(row.truth)), CsvField(row.split),
                                 StrCat(row.jobs.done), StrCat(row.jobs.planned)});
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
      AddCell(row.cells[i], line.cells[i], fields);
      if (!table.reference.empty()) AddDifference(row.cells[i].difference, fields);
    }
    csv += Joined(fields, ",") + "\r\n";
  }
  return csv;
}

}  // namespace cvo::reports
