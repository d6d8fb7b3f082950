// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/tables/table_text.h"

#include <algorithm>

#include "core/base/error.h"
#include "reports/tables/printable.h"
#include "reports/tables/table_texts.h"

namespace cvo::reports {
namespace {

constexpr char kDim[] = "\033[2m";
constexpr char kPlain[] = "\033[0m";

// A number as printed, with its marks behind it so that digits stand below digits.
struct Entry {
  std::string text;
  std::string marks;
  bool grey = false;
};
using Entries = std::vector<Entry>;

struct Layout {
  std::size_t text_columns = 0;
  std::vector<std::size_t> widths;  // without the marks
  std::vector<std::size_t> marks;
};

std::string MarksOf(const CellText& cell) {
  return StrCat(cell.distinguishable ? "*" : "", cell.best ? "^" : "");
}

// A value above its interval, percent and its interval, each only where any cell has one.
std::vector<Entries> EntriesOf(const TextLine& line) {
  Entries values;
  for (const std::string& text : line.texts) values.push_back({text, "", line.grey});
  for (const CellText& cell : line.cells) {
    values.push_back({cell.Shown(), MarksOf(cell), cell.grey});
  }
  std::vector<Entries> rows = {values};
  for (const auto part : {&CellText::interval, &CellText::percent, &CellText::percent_interval}) {
    Entries entries(line.texts.size());
    for (const CellText& cell : line.cells) entries.push_back({cell.*part, "", cell.grey});
    const bool any = std::any_of(entries.begin(), entries.end(),
                                 [](const Entry& entry) { return !entry.text.empty(); });
    if (any) rows.push_back(std::move(entries));
  }
  return rows;
}

Entries HeaderEntries(const TableTexts& texts) {
  Entries header;
  for (const std::string& name : texts.text_header) header.push_back({name, "", false});
  for (const ColumnText& column : texts.columns) header.push_back({column.Heading(), "", false});
  return header;
}

Layout MeasureLayout(const TableTexts& texts) {
  Layout layout;
  layout.text_columns = texts.text_header.size();
  const Entries header = HeaderEntries(texts);
  for (const Entry& entry : header) layout.widths.push_back(Width(entry.text));
  layout.marks.resize(header.size());
  for (const TextBlock& block : texts.blocks) {
    for (const TextLine& line : block.lines) {
      for (const Entries& entries : EntriesOf(line)) {
        for (std::size_t i = 0; i < entries.size(); ++i) {
          layout.widths[i] = std::max(layout.widths[i], Width(entries[i].text));
          layout.marks[i] = std::max(layout.marks[i], entries[i].marks.size());
        }
      }
    }
  }
  return layout;
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
    line += i > 0 ? "  " : "";
    line += dim && entries[i].grey && !entries[i].text.empty() ? kDim + text + kPlain : text;
  }
  line.erase(line.find_last_not_of(' ') + 1);
  return line + "\n";
}

}  // namespace

std::string TableText(const Table& table, bool dim) {
  const TableTexts texts = MakeTexts(table);
  const Layout layout = MeasureLayout(texts);
  std::string text = texts.title.empty() ? "" : texts.title + "\n";
  if (!texts.about.empty()) text += texts.about + "\n";
  for (const TextBlock& block : texts.blocks) {
    if (!text.empty()) text += "\n";
    if (!block.heading.empty()) text += block.heading + "\n";
    text += LineText(HeaderEntries(texts), layout, dim);
    for (const TextLine& line : block.lines) {
      for (const Entries& entries : EntriesOf(line)) text += LineText(entries, layout, dim);
    }
  }
  text += "\n";
  if (texts.any_best) text += BestNote("^") + "\n";
  for (const std::string& note : texts.footnotes) text += note + "\n";
  return text;
}

}  // namespace cvo::reports
