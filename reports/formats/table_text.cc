// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/formats/table_text.h"

#include <algorithm>
#include <limits>
#include <numeric>

#include "core/base/error.h"
#include "core/files/text/utf8.h"
#include "reports/formats/column_panels.h"
#include "reports/formats/table_texts.h"

namespace cvo::reports {
namespace {

constexpr char kDim[] = "\033[2m";
constexpr char kPlain[] = "\033[0m";
constexpr std::size_t kGap = 2;

// A text as printed, with its marks separate so that digits align.
struct Entry {
  std::string text;
  std::string marks;
  bool grey = false;
};
using Entries = std::vector<Entry>;

// Widths of all columns, texts at the left first.
struct Layout {
  std::size_t text_columns = 0;
  std::vector<std::size_t> widths;  // without the marks
  std::vector<std::size_t> marks;
};

std::string MarksOf(const CellText& cell) {
  return StrCat(cell.distinguishable ? "*" : "", cell.best ? "^" : "");
}

// Returns the printed rows of a line: values, intervals, percentages and intervals of these, each
// only if some cell has one.
std::vector<Entries> EntriesOf(const TextLine& line, const std::vector<std::size_t>& columns) {
  Entries values;
  for (const std::string& text : line.texts) values.push_back({text, "", line.grey});
  for (const std::size_t column : columns) {
    const CellText& cell = line.cells[column];
    values.push_back({cell.Shown(), MarksOf(cell), cell.grey});
  }
  std::vector<Entries> rows = {values};
  for (const auto part : {&CellText::interval, &CellText::percent, &CellText::percent_interval}) {
    Entries entries(line.texts.size());
    for (const std::size_t column : columns) {
      entries.push_back({line.cells[column].*part, "", line.cells[column].grey});
    }
    const bool any = std::any_of(entries.begin(), entries.end(),
                                 [](const Entry& entry) { return !entry.text.empty(); });
    if (any) rows.push_back(std::move(entries));
  }
  return rows;
}

Entries HeaderEntries(const TableTexts& texts, const std::vector<std::size_t>& columns) {
  Entries header;
  for (const std::string& name : texts.text_header) header.push_back({name, "", false});
  for (const std::size_t column : columns) {
    header.push_back({texts.columns[column].Heading(), "", false});
  }
  return header;
}

Layout MeasureLayout(const TableTexts& texts, const std::vector<std::size_t>& columns) {
  Layout layout;
  layout.text_columns = texts.text_header.size();
  const Entries header = HeaderEntries(texts, columns);
  for (const Entry& entry : header) layout.widths.push_back(Width(entry.text));
  layout.marks.resize(header.size());
  for (const TextBlock& block : texts.blocks) {
    for (const TextLine& line : block.lines) {
      for (const Entries& entries : EntriesOf(line, columns)) {
        for (std::size_t i = 0; i < entries.size(); ++i) {
          layout.widths[i] = std::max(layout.widths[i], Width(entries[i].text));
          layout.marks[i] = std::max(layout.marks[i], entries[i].marks.size());
        }
      }
    }
  }
  return layout;
}

std::vector<std::vector<std::size_t>> SplitForWidth(const TableTexts& texts, std::size_t width) {
  std::vector<std::size_t> all(texts.columns.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  if (width == 0) return {all};
  const Layout layout = MeasureLayout(texts, all);
  auto room = static_cast<double>(width);
  for (std::size_t i = 0; i < layout.text_columns; ++i) {
    room -= static_cast<double>(layout.widths[i] + (i > 0 ? kGap : 0));
  }
  std::vector<double> widths;
  for (std::size_t i = layout.text_columns; i < layout.widths.size(); ++i) {
    widths.push_back(static_cast<double>(kGap + layout.widths[i] + layout.marks[i]));
  }
  return SplitColumns(texts.columns, widths, room);
}

std::string Padded(const Entry& entry, std::size_t column, const Layout& layout) {
  const std::string blanks(layout.widths[column] - Width(entry.text), ' ');
  const std::string behind(layout.marks[column] - entry.marks.size(), ' ');
  return column < layout.text_columns ? entry.text + blanks
                                      : blanks + entry.text + entry.marks + behind;
}

std::string LineText(const Entries& entries, const Layout& layout, bool dim) {
  std::string line;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const std::string text = Padded(entries[i], i, layout);
    if (i > 0) line.append(kGap, ' ');
    line += dim && entries[i].grey && !entries[i].text.empty() ? kDim + text + kPlain : text;
  }
  line.erase(line.find_last_not_of(' ') + 1);
  return line + "\n";
}

std::string PanelText(const TableTexts& texts, const TextBlock& block,
                      const std::vector<std::size_t>& columns, bool dim) {
  const Layout layout = MeasureLayout(texts, columns);
  std::string text = LineText(HeaderEntries(texts, columns), layout, dim);
  for (const TextLine& line : block.lines) {
    if (!columns.empty() && !HasValue(line, columns)) continue;
    for (const Entries& entries : EntriesOf(line, columns)) text += LineText(entries, layout, dim);
  }
  return text;
}

}  // namespace

std::string TableText(const Table& table, bool dim, std::size_t width) {
  const TableTexts texts = MakeTexts(table);
  const auto panels = SplitForWidth(texts, width);
  std::string text = texts.title.empty() ? "" : texts.title + "\n";
  if (!texts.about.empty()) text += texts.about + "\n";
  for (const TextBlock& block : texts.blocks) {
    if (!block.heading.empty()) text += "\n" + block.heading + "\n";
    for (const auto& columns : panels) {
      const bool behind_heading = !block.heading.empty() && &columns == &panels.front();
      if (!text.empty() && !behind_heading) text += "\n";
      text += PanelText(texts, block, columns, dim);
    }
  }
  text += "\n";
  if (texts.any_best) text += BestNote("^") + "\n";
  for (const std::string& note : texts.footnotes) text += note + "\n";
  return text;
}

}  // namespace cvo::reports
