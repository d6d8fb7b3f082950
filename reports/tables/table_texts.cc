// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/tables/table_texts.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "core/files/text/number.h"
#include "core/files/text/utf8.h"
#include "core/record/metric_catalogue.h"

namespace cvo::reports {
namespace {

constexpr int kMaxDecimals = 9;

// Returns the number of decimals that shows the given significant digits of a nonzero value.
int Significant(double value, int digits) {
  return std::clamp(digits - 1 - static_cast<int>(std::floor(std::log10(std::abs(value)))), 0,
                    kMaxDecimals);
}

int ByUnit(double value, const std::string& unit) {
  if (unit == kCountUnit) return value == std::floor(value) ? 0 : 2;
  if (unit == "m" || unit == "rad") return std::abs(value) < 0.01 && value != 0.0 ? 5 : 4;
  if (unit == "%") return 2;
  if (unit == "1" || value == 0.0) return 3;
  return Significant(value, 4);
}

// Returns the magnitude that determines the number of digits: that of the value or, if it is 0, of
// its interval.
double Magnitude(const Measured& figure) {
  if (figure.value != 0.0 || !figure.interval) return figure.value;
  return std::max(std::abs(figure.interval->low), std::abs(figure.interval->high));
}

// Returns the decimals that follow from the interval; empty if it does not determine them. A
// relatively narrower one is of equal values up to rounding.
std::optional<int> ByInterval(const Measured& figure) {
  constexpr double kNoWidth = 1e-9;
  if (!figure.interval) return std::nullopt;
  const double half = 0.5 * (figure.interval->high - figure.interval->low);
  const double magnitude = Magnitude(figure);
  if (!(half > kNoWidth * std::abs(magnitude)) || !std::isfinite(half)) return std::nullopt;
  if (magnitude == 0.0) return Significant(half, 2);
  return std::clamp(Significant(half, 2), Significant(magnitude, 2), Significant(magnitude, 4));
}

std::string RangeText(const Interval& interval, int decimals) {
  return Fixed(interval.low, decimals) + ".." + Fixed(interval.high, decimals);
}

bool ShowsSequences(const Table& table) {
  return std::find(table.keys.begin(), table.keys.end(), "sequence") != table.keys.end();
}

// Older results do not state the split.
bool ShowsSplits(const Table& table) {
  return std::ranges::any_of(table.rows, [](const Row& row) { return !row.split.empty(); });
}

std::vector<std::string> AllPrintable(std::vector<std::string> lines) {
  for (std::string& line : lines) line = Printable(line);
  return lines;
}

std::vector<std::string> TextHeader(const Table& table) {
  std::vector<std::string> header = table.keys;
  if (ShowsSequences(table)) header.insert(header.end(), {"frames", "truth"});
  if (ShowsSplits(table)) header.emplace_back("split");
  header.emplace_back("runs");
  return AllPrintable(header);
}

// The truth is shown by its name, without the definition of visibility.
std::vector<std::string> ResultTexts(const Row& row, const Table& table) {
  std::vector<std::string> texts = row.keys;
  if (ShowsSequences(table)) {
    texts.push_back(row.sequence ? FrameRange(row.sequence->first_frame, row.sequence->frames)
                                 : "-");
    texts.emplace_back(row.truth.truth ? NameOf(*row.truth.truth) : "-");
  }
  if (ShowsSplits(table)) texts.push_back(row.split);
  texts.push_back(StrCat(row.jobs.done, "/", row.jobs.planned));
  return AllPrintable(texts);
}

CellText ValueText(const Cell& cell, int decimals) {
  CellText text;
  text.value = "-";
  if (!cell.value) {
    text.note = Printable(cell.message);
    return text;
  }
  text.value = Fixed(*cell.value, decimals);
  if (cell.interval) text.interval = RangeText(*cell.interval, decimals);
  text.n = CountsText(cell.n);
  text.distinguishable = cell.difference && cell.difference->distinguishable;
  text.grey = !cell.not_comparable.empty();
  if (text.grey) text.note = Printable("defined differently: " + cell.not_comparable);
  return text;
}

// Formats a published figure as it was printed.
CellText ReferenceText(const ReferenceCell* cell) {
  CellText text;
  if (cell == nullptr) return text;
  text.value = FormatGeneral(cell->value, 6);
  text.grey = cell->match != Match::kMatches;
  text.note = Printable(cell->reason);
  if (text.grey && text.note.empty()) text.note = NameOf(cell->match);
  if (cell->match == Match::kContractUnknown && !cell->reason.empty()) {
    text.note = "contract " + text.note;
  }
  return text;
}

TextLine ReferenceLine(const ReferenceRow& line, const Row* row, const Table& table) {
  TextLine texts{row, &line};
  texts.texts.resize(TextHeader(table).size());
  const auto variant = std::find(table.keys.begin(), table.keys.end(), "variant");
  const auto at = variant == table.keys.end() ? 0 : variant - table.keys.begin();
  texts.texts[static_cast<std::size_t>(at)] =
      Printable(line.system) + " " + SourceMark(table, line.source);
  if (line.frames > 0 && ShowsSequences(table)) {
    texts.texts[table.keys.size()] = FrameRange(line.first_frame, line.frames);
  }
  texts.grey = true;
  for (const Column& column : table.columns) {
    const ReferenceCell* cell = line.Find(column);
    texts.cells.push_back(ReferenceText(cell));
    if (cell != nullptr && cell->match == Match::kMatches) texts.grey = false;
  }
  return texts;
}

// The difference and its percentage have the sign of the row's value minus the reference's.
CellText DifferenceText(const std::optional<Difference>& difference, int decimals) {
  CellText text;
  if (!difference) return text;
  const auto with_sign = [](const std::string& number) {
    return number[0] != '-' ? "+" + number : number;
  };
  text.value = with_sign(Fixed(difference->difference, decimals));
  if (difference->interval) text.interval = RangeText(*difference->interval, decimals);
  if (difference->percent) text.percent = with_sign(Fixed(*difference->percent, 1)) + "%";
  if (difference->truth_gap) text.percent = "within the gap of the truths";
  text.n = Counted(difference->pairs, "pair");
  text.distinguishable = difference->distinguishable;
  return text;
}

std::string UnitForDigits(const Column& column) {
  const MetricEntry* rule = FindEntry(column.metric);
  return rule && rule->kind == MetricKind::kCount ? kCountUnit : column.unit;
}

// Differences have as many decimals as the values, and one more if their interval supports it. The
// decimals that a difference close to 0 would get by itself would be noise.
void AddColumn(const Table& table, std::size_t column, std::vector<TextLine>& values,
               std::vector<TextLine>& differences) {
  std::vector<Measured> of_rows;
  std::vector<Measured> changes;
  for (const Row& row : table.rows) {
    const auto& [value, difference] =
        std::tie(row.cells[column].value, row.cells[column].difference);
    of_rows.push_back({value.value_or(0.0), row.cells[column].interval});
    if (difference) changes.push_back({difference->difference, difference->interval});
  }
  const std::string unit = UnitForDigits(table.columns[column]);
  const std::vector<int> decimals = ColumnDecimals(of_rows, unit);
  const std::vector<int> own = ColumnDecimals(changes, unit);
  int most = 0;
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    if (table.rows[i].cells[column].value) most = std::max(most, decimals[i]);
  }
  auto next = own.begin();
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    const Cell& cell = table.rows[i].cells[column];
    values[i].cells.push_back(ValueText(cell, decimals[i]));
    const int digits = cell.difference ? std::clamp(*next++, most, most + 1) : 0;
    differences[i].cells.push_back(DifferenceText(cell.difference, digits));
  }
}

// Adds the values, and the differences if there are any, without rows that have none, such as the
// reference itself.
void AddBlocks(const Table& table, TableTexts& texts) {
  std::vector<TextLine> values;
  for (const Row& row : table.rows) values.push_back({&row, nullptr, ResultTexts(row, table)});
  std::vector<TextLine> differences = values;
  for (std::size_t i = 0; i < table.columns.size(); ++i) AddColumn(table, i, values, differences);
  std::vector<TextLine>& lines = texts.blocks.emplace_back().lines;
  for (TextLine& line : values) {
    const Row* row = line.row;
    lines.push_back(std::move(line));
    for (const auto& theirs : row->reference) lines.push_back(ReferenceLine(theirs, row, table));
  }
  for (const auto& theirs : table.others) lines.push_back(ReferenceLine(theirs, nullptr, table));
  std::erase_if(differences, [](const TextLine& line) {
    return std::all_of(line.cells.begin(), line.cells.end(),
                       [](const CellText& cell) { return cell.value.empty(); });
  });
  if (differences.empty()) return;
  const std::string reference = Printable(table.reference);
  texts.blocks.push_back({StrCat("difference from ", reference,
                                 " (paired): value, 95 % interval, and percent of ", reference),
                          std::move(differences)});
}

}  // namespace

std::vector<int> ColumnDecimals(const std::vector<Measured>& figures, const std::string& unit) {
  std::optional<int> most;
  for (const Measured& figure : figures) {
    if (const std::optional<int> own = ByInterval(figure)) most = std::max(most.value_or(0), *own);
  }
  std::vector<int> decimals;
  for (const Measured& figure : figures) {
    const bool alone = !figure.interval || !most;
    const double magnitude = Magnitude(figure);
    const int limit = magnitude == 0.0 ? kMaxDecimals : Significant(magnitude, 4);
    decimals.push_back(alone ? ByUnit(figure.value, unit)
                             : std::max(ByInterval(figure).value_or(0), std::min(*most, limit)));
  }
  return decimals;
}

std::string Fixed(double value, int decimals) {
  std::string fixed = FormatFixed(value, decimals);
  if (fixed[0] == '-' && fixed.find_first_not_of("-0.") == std::string::npos) fixed.erase(0, 1);
  return fixed;
}

std::string CellText::Shown() const {
  return grey && !value.empty() ? StrCat("(", value, ")") : value;
}

TableTexts MakeTexts(const Table& table) {
  TableTexts texts;
  texts.title = Printable(table.title);
  texts.about = Printable(table.about);
  texts.text_header = TextHeader(table);
  for (const Column& column : table.columns) {
    texts.columns.push_back(
        Printable(StrCat(column.label, column.unit == "1" ? "" : " [" + column.unit + "]")));
  }
  AddBlocks(table, texts);
  texts.footnotes = AllPrintable(Footnotes(table));
  return texts;
}

}  // namespace cvo::reports
