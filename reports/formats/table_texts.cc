// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/formats/table_texts.h"

#include <algorithm>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "core/files/text/number.h"
#include "core/files/text/utf8.h"
#include "reports/formats/best_cells.h"
#include "reports/formats/digits.h"
#include "reports/results/metric_catalogue.h"
#include "reports/tables/footnotes.h"

namespace cvo::reports {
namespace {

std::string RangeText(const Interval& interval, int decimals) {
  return Fixed(interval.low, decimals) + ".." + Fixed(interval.high, decimals);
}

std::string FrameRange(int first, int count) { return StrCat(first, ":", first + count); }

bool ShowsSequences(const Table& table) {
  return std::find(table.keys.begin(), table.keys.end(), "sequence") != table.keys.end();
}

// Older results do not state the split.
bool ShowsSplits(const Table& table) {
  return std::any_of(table.rows.begin(), table.rows.end(),
                     [](const Row& row) { return !row.split.empty(); });
}

std::vector<std::string> TextHeader(const Table& table) {
  std::vector<std::string> header = table.keys;
  if (ShowsSequences(table)) header.insert(header.end(), {"frames", "truth"});
  if (ShowsSplits(table)) header.emplace_back("split");
  header.emplace_back("runs");
  return header;
}

// The truth as shown in a cell: its name, without the definition of visibility.
std::string ShortTruth(const Contract& contract) {
  return contract.truth ? NameOf(*contract.truth) : "-";
}

std::vector<std::string> ResultTexts(const Row& row, const Table& table) {
  std::vector<std::string> texts;
  for (const std::string& key : row.keys) texts.push_back(Printable(key));
  if (ShowsSequences(table)) {
    texts.push_back(row.sequence ? FrameRange(row.sequence->first_frame, row.sequence->frames)
                                 : "-");
    texts.push_back(Printable(ShortTruth(row.truth)));
  }
  if (ShowsSplits(table)) texts.push_back(Printable(row.split));
  texts.push_back(StrCat(row.jobs.done, "/", row.jobs.planned));
  return texts;
}

CellText ValueText(const Cell& cell, int decimals) {
  CellText text;
  text.value = "-";
  if (!cell.present) {
    text.note = Printable(cell.message);
    return text;
  }
  text.value = Fixed(cell.value, decimals);
  if (cell.interval) text.interval = RangeText(*cell.interval, decimals);
  text.n = CountsText(cell.n);
  text.units = UnitsText(cell.n);
  text.distinguishable = cell.difference && cell.difference->distinguishable;
  text.grey = !cell.not_comparable.empty();
  if (text.grey) text.note = Printable("defined differently: " + cell.not_comparable);
  return text;
}

// Formats a published figure as it was printed.
CellText ReferenceText(const std::optional<ReferenceCell>& cell) {
  CellText text;
  if (!cell) return text;
  text.value = FormatGeneral(cell->value, 6);
  text.grey = cell->match != Match::kMatches;
  text.note = Printable(cell->reason);
  if (text.grey && text.note.empty()) text.note = NameOf(cell->match);
  if (cell->match == Match::kContractUnknown && !cell->reason.empty()) {
    text.note = "contract " + text.note;
  }
  return text;
}

TextLine ReferenceLine(const ReferenceRow& line, const Table& table) {
  TextLine texts;
  texts.texts.resize(TextHeader(table).size());
  const auto variant = std::find(table.keys.begin(), table.keys.end(), "variant");
  const auto at = variant == table.keys.end() ? 0 : variant - table.keys.begin();
  texts.texts[static_cast<std::size_t>(at)] =
      Printable(line.system) + " " + SourceMark(line.source);
  if (line.frames > 0 && ShowsSequences(table)) {
    texts.texts[table.keys.size()] = FrameRange(line.first_frame, line.frames);
  }
  texts.grey = true;
  for (const auto& cell : line.cells) {
    texts.cells.push_back(ReferenceText(cell));
    if (cell && cell->match == Match::kMatches) texts.grey = false;
  }
  return texts;
}

std::string PercentText(double percent) {
  const std::string text = Fixed(percent, 1);
  return StrCat(text[0] != '-' ? "+" : "", text, "%");
}

std::string PercentRangeText(const Interval& interval) {
  return StrCat(Fixed(interval.low, 0), "..", Fixed(interval.high, 0), "%");
}

// The difference and its percentage have the sign of the row's value minus the reference's.
CellText DifferenceText(const Difference& difference, int decimals) {
  CellText text;
  text.value = Fixed(difference.difference, decimals);
  if (text.value[0] != '-') text.value = "+" + text.value;
  if (difference.interval) text.interval = RangeText(*difference.interval, decimals);
  if (difference.percent) text.percent = PercentText(*difference.percent);
  if (difference.percent_interval) {
    text.percent_interval = PercentRangeText(*difference.percent_interval);
  }
  text.n = Counted(difference.pairs, "pair");
  text.units = text.n;
  text.distinguishable = difference.distinguishable;
  return text;
}

std::string UnitForDigits(const Column& column) {
  const MetricEntry* rule = FindEntry(column.metric);
  return rule && rule->kind == MetricKind::kCount ? kCountUnit : column.unit;
}

// Returns the decimals for those cells of a column that are comparable, or for those that are not.
std::vector<int> DecimalsOf(const Table& table, std::size_t column, bool comparable) {
  std::vector<Measured> figures;
  for (const Row& row : table.rows) {
    const Cell& cell = row.cells[column];
    if (cell.present && cell.not_comparable.empty() == comparable) {
      figures.push_back({cell.value, cell.interval});
    }
  }
  return ColumnDecimals(figures, UnitForDigits(table.columns[column]));
}

// Appends the cell of one column to each of our lines.
void AddValueColumn(const Table& table, std::size_t column, std::vector<TextLine>& lines) {
  const std::vector<int> comparable = DecimalsOf(table, column, true);
  const std::vector<int> others = DecimalsOf(table, column, false);
  auto next = comparable.begin();
  auto next_other = others.begin();
  for (TextLine& line : lines) {
    const Cell& cell = table.rows[*line.row].cells[column];
    if (!cell.present) {
      line.cells.push_back(ValueText(cell, 0));
    } else {
      line.cells.push_back(ValueText(cell, cell.not_comparable.empty() ? *next++ : *next_other++));
    }
  }
}

// Differences have as many decimals as the values, and one more if their interval supports it. The
// decimals that a difference close to 0 would get by itself would be noise.
void AddDifferenceColumn(const Table& table, std::size_t column, std::vector<TextLine>& lines) {
  std::vector<Measured> figures;
  for (const Row& row : table.rows) {
    const auto& difference = row.cells[column].difference;
    if (difference) figures.push_back({difference->difference, difference->interval});
  }
  std::vector<int> decimals = ColumnDecimals(figures, UnitForDigits(table.columns[column]));
  const std::vector<int> values = DecimalsOf(table, column, true);
  const int most = values.empty() ? 0 : *std::max_element(values.begin(), values.end());
  for (int& count : decimals) count = std::clamp(count, most, most + 1);
  std::size_t index = 0;
  for (TextLine& line : lines) {
    const auto& difference = table.rows[*line.row].cells[column].difference;
    line.cells.push_back(difference ? DifferenceText(*difference, decimals[index++]) : CellText{});
  }
}

// Returns a line for each of our rows, without cells.
std::vector<TextLine> ResultLines(const Table& table) {
  std::vector<TextLine> lines;
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    lines.push_back({i, std::nullopt, ResultTexts(table.rows[i], table), {}, false});
  }
  return lines;
}

TextBlock ValueBlock(const Table& table) {
  std::vector<TextLine> ours = ResultLines(table);
  for (std::size_t i = 0; i < table.columns.size(); ++i) AddValueColumn(table, i, ours);
  TextBlock block;
  for (TextLine& line : ours) {
    const std::vector<ReferenceRow>& references = table.rows[*line.row].reference;
    const std::size_t row = *line.row;
    block.lines.push_back(std::move(line));
    for (std::size_t i = 0; i < references.size(); ++i) {
      block.lines.push_back(ReferenceLine(references[i], table));
      block.lines.back().row = row;
      block.lines.back().reference = i;
    }
  }
  for (std::size_t i = 0; i < table.others.size(); ++i) {
    block.lines.push_back(ReferenceLine(table.others[i], table));
    block.lines.back().reference = i;
  }
  return block;
}

// Omits rows that have no difference, such as the reference itself.
TextBlock DifferenceBlock(const Table& table) {
  std::vector<TextLine> lines = ResultLines(table);
  for (std::size_t i = 0; i < table.columns.size(); ++i) AddDifferenceColumn(table, i, lines);
  std::erase_if(lines, [](const TextLine& line) {
    return std::all_of(line.cells.begin(), line.cells.end(),
                       [](const CellText& cell) { return cell.value.empty(); });
  });
  const std::string reference = Printable(table.reference);
  return {StrCat("difference from ", reference, " (paired): value, 95 % interval, and percent of ",
                 reference),
          std::move(lines)};
}

std::vector<ColumnText> ColumnTexts(const Table& table) {
  std::vector<ColumnText> columns;
  for (const Column& column : table.columns) {
    const std::string coverage = CoverageOf(column.metric);
    const Column* found = FindBy(table.columns, &Column::metric, coverage);
    columns.push_back(
        {Printable(column.label), column.unit == "1" ? "" : Printable(column.unit), {}});
    if (found == nullptr || coverage == column.metric) continue;
    columns.back().coverage = static_cast<std::size_t>(found - table.columns.data());
  }
  return columns;
}

std::vector<std::string> AllPrintable(const std::vector<std::string>& lines) {
  std::vector<std::string> printable;
  for (const std::string& line : lines) printable.push_back(Printable(line));
  return printable;
}

}  // namespace

std::string CellText::Shown() const {
  return grey && !value.empty() ? StrCat("(", value, ")") : value;
}

std::string ColumnText::Heading() const {
  return unit.empty() ? label : StrCat(label, " [", unit, "]");
}

TableTexts MakeTexts(const Table& table) {
  TableTexts texts;
  texts.title = Printable(table.title);
  texts.about = Printable(table.about);
  texts.text_header = AllPrintable(TextHeader(table));
  texts.columns = ColumnTexts(table);
  texts.blocks.push_back(ValueBlock(table));
  texts.any_best = MarkBest(table, texts.blocks[0].lines);
  TextBlock differences = DifferenceBlock(table);
  if (!differences.lines.empty()) texts.blocks.push_back(std::move(differences));
  texts.footnotes = AllPrintable(Footnotes(table));
  texts.definitions = AllPrintable(Definitions(table));
  return texts;
}

std::string BestNote(const std::string& mark) {
  return mark +
         ": best value of the column among rows on the same data, whether or not the difference is "
         "significant";
}

}  // namespace cvo::reports
