// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <numeric>
#include <string_view>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "core/files/text/utf8.h"
#include "reports/tables/table_texts.h"

namespace cvo::reports {
namespace {

constexpr std::size_t kGap = 2;

// A text as printed, with its marks separate so that digits align.
struct Entry {
  std::string text;
  std::string marks = {};
};
using Entries = std::vector<Entry>;

// Widths of all columns, texts at the left first.
struct Layout {
  std::size_t text_columns = 0;
  std::vector<std::size_t> widths;  // without the marks
  std::vector<std::size_t> marks;
};

// Returns the printed rows of a line: values, intervals, percentages and intervals of these, each
// only if some cell has one.
std::vector<Entries> EntriesOf(const TextLine& line, const std::vector<std::size_t>& columns) {
  Entries values;
  for (const std::string& text : line.texts) values.push_back({text});
  for (const std::size_t column : columns) {
    const CellText& cell = line.cells[column];
    values.push_back({cell.Shown(), cell.distinguishable ? "*" : ""});
  }
  std::vector<Entries> rows = {values};
  for (const auto part : {&CellText::interval, &CellText::percent, &CellText::percent_interval}) {
    Entries entries(line.texts.size());
    for (const std::size_t column : columns) {
      entries.push_back({line.cells[column].*part});
    }
    const bool any = std::any_of(entries.begin(), entries.end(),
                                 [](const Entry& entry) { return !entry.text.empty(); });
    if (any) rows.push_back(std::move(entries));
  }
  return rows;
}

Entries HeaderEntries(const TableTexts& texts, const std::vector<std::size_t>& columns) {
  Entries header;
  for (const std::string& name : texts.text_header) header.push_back({name});
  for (const std::size_t column : columns) {
    header.push_back({texts.columns[column].Heading()});
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

std::vector<std::size_t> AllColumns(const TableTexts& texts) {
  std::vector<std::size_t> all(texts.columns.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  return all;
}

// Splits a table that is too wide into parts. Returns the columns of each part: from left to right
// as many as fit, at least one.
std::vector<std::vector<std::size_t>> SplitForWidth(const TableTexts& texts, std::size_t width) {
  const std::vector<std::size_t> all = AllColumns(texts);
  if (width == 0) return {all};
  const Layout layout = MeasureLayout(texts, all);
  std::size_t left = 0;
  for (std::size_t i = 0; i < layout.text_columns; ++i) {
    left += layout.widths[i] + (i > 0 ? kGap : 0);
  }
  std::vector<std::vector<std::size_t>> panels = {{}};
  std::size_t used = left;
  for (const std::size_t column : all) {
    const std::size_t at = layout.text_columns + column;
    const std::size_t more = kGap + layout.widths[at] + layout.marks[at];
    if (!panels.back().empty() && used + more > width) {
      panels.emplace_back();
      used = left;
    }
    panels.back().push_back(column);
    used += more;
  }
  return panels;
}

std::string Padded(const Entry& entry, std::size_t column, const Layout& layout) {
  const std::string blanks(layout.widths[column] - Width(entry.text), ' ');
  const std::string behind(layout.marks[column] - entry.marks.size(), ' ');
  return column < layout.text_columns ? entry.text + blanks
                                      : blanks + entry.text + entry.marks + behind;
}

std::string LineText(const Entries& entries, const Layout& layout) {
  std::string line;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    if (i > 0) line.append(kGap, ' ');
    line += Padded(entries[i], i, layout);
  }
  line.erase(line.find_last_not_of(' ') + 1);
  return line + "\n";
}

std::string PanelText(const TableTexts& texts, const TextBlock& block,
                      const std::vector<std::size_t>& columns) {
  const Layout layout = MeasureLayout(texts, columns);
  std::string text = LineText(HeaderEntries(texts, columns), layout);
  for (const TextLine& line : block.lines) {
    const bool has_value = std::any_of(columns.begin(), columns.end(), [&](std::size_t column) {
      return !line.cells[column].value.empty();
    });
    if (!columns.empty() && !has_value) continue;
    for (const Entries& entries : EntriesOf(line, columns)) text += LineText(entries, layout);
  }
  return text;
}

// Escapes a standalone line so that it does not become a list, a heading or a rule.
std::string Paragraph(const std::string& text) {
  return (std::string("-+=").find(text[0]) != std::string::npos ? "\\" : "") +
         MarkdownEscaped(text);
}

std::string CellMarkdown(const CellText& cell) {
  if (cell.value.empty()) return "";
  std::string text = cell.Shown();
  if (cell.distinguishable) text += "\\*";
  if (!cell.interval.empty()) text += " (" + cell.interval + ")";
  if (!cell.percent.empty()) text += "; " + cell.percent;
  if (!cell.percent_interval.empty()) text += " (" + cell.percent_interval + ")";
  return text;
}

std::string LineMarkdown(const TextLine& line) {
  std::string text;
  const auto add = [&text](const std::string& cell, bool grey) {
    text += grey && !cell.empty() ? "| *" + cell + "* " : "| " + cell + " ";
  };
  for (const std::string& cell : line.texts) add(MarkdownEscaped(cell), line.grey);
  for (const CellText& cell : line.cells) add(CellMarkdown(cell), cell.grey);
  return text + "|\n";
}

std::string HeaderMarkdown(const TableTexts& texts) {
  std::string header;
  std::string rule;
  for (const std::string& name : texts.text_header) {
    header += "| " + MarkdownEscaped(name) + " ";
    rule += "|---";
  }
  for (const ColumnText& column : texts.columns) {
    header += "| " + MarkdownEscaped(column.Heading()) + " ";
    rule += "|---:";
  }
  return header + "|\n" + rule + "|\n";
}

// Brackets and stars in braces: LaTeX would take them for arguments of the end of the row before.
std::string LatexEscaped(const std::string& text) {
  constexpr std::string_view kNamed = "\\^~<>|`";
  constexpr std::array<const char*, 7> kNames = {"backslash", "asciicircum", "asciitilde", "less",
                                                 "greater",   "bar",         "asciigrave"};
  std::string escaped;
  for (const char c : text) {
    const std::size_t named = kNamed.find(c);
    if (named != std::string_view::npos) {
      escaped += StrCat("\\text", kNames.at(named), "{}");
    } else if (std::string_view("{}$&#_%").find(c) != std::string_view::npos) {
      escaped += {'\\', c};
    } else if (c == '[' || c == '*') {
      escaped += {'{', c, '}'};
    } else {
      escaped += c == '"' ? "''" : std::string(1, c);
    }
  }
  return escaped;
}

// A number or a range of two, with proper minus signs.
std::string LatexNumber(const std::string& text) {
  if (text == "-") return "--";
  std::string number;
  for (const char c : text) number += c == '-' ? "$-$" : c == '%' ? "\\%" : std::string(1, c);
  return number;
}

std::string EntryLatex(const Entry& entry, bool is_value) {
  const std::string number = LatexNumber(entry.text);
  if (!is_value) return number.empty() ? "" : StrCat("{\\scriptsize ", number, "}");
  return number + (entry.marks.empty() ? "" : "\\rlap{$^{*}$}");
}

std::string LineLatex(const TextLine& line, const std::vector<std::size_t>& columns) {
  std::string latex;
  bool is_value = true;
  for (const Entries& entries : EntriesOf(line, columns)) {
    std::vector<std::string> cells;
    for (const Entry& entry : entries) {
      cells.push_back(cells.size() < line.texts.size() ? LatexEscaped(entry.text)
                                                       : EntryLatex(entry, is_value));
    }
    latex += Joined(cells, " & ") + " \\\\\n";
    is_value = false;
  }
  return latex;
}

std::string Comments(const std::vector<std::string>& lines) {
  std::string latex;
  for (const std::string& line : lines) latex += StrCat("% ", line, "\n");
  return latex;
}

}  // namespace

std::string TableText(const Table& table, std::size_t width) {
  const TableTexts texts = MakeTexts(table);
  const auto panels = SplitForWidth(texts, width);
  std::string text = texts.title.empty() ? "" : texts.title + "\n";
  if (!texts.about.empty()) text += texts.about + "\n";
  for (const TextBlock& block : texts.blocks) {
    if (!block.heading.empty()) text += "\n" + block.heading + "\n";
    for (const auto& columns : panels) {
      const bool behind_heading = !block.heading.empty() && &columns == &panels.front();
      if (!text.empty() && !behind_heading) text += "\n";
      text += PanelText(texts, block, columns);
    }
  }
  text += "\n";
  for (const std::string& note : texts.footnotes) text += note + "\n";
  return text;
}

std::string TableMarkdown(const Table& table) {
  const TableTexts texts = MakeTexts(table);
  std::string text = texts.title.empty() ? "" : "**" + MarkdownEscaped(texts.title) + "**\n\n";
  if (!texts.about.empty()) text += Paragraph(texts.about) + "\n\n";
  for (const TextBlock& block : texts.blocks) {
    if (!block.heading.empty()) text += MarkdownEscaped(block.heading) + ":\n\n";
    text += HeaderMarkdown(texts);
    for (const TextLine& line : block.lines) text += LineMarkdown(line);
    text += "\n";
  }
  for (const std::string& note : texts.footnotes) text += "- " + MarkdownEscaped(note) + "\n";
  for (const std::string& note : texts.definitions) text += "- " + MarkdownEscaped(note) + "\n";
  return text;
}

std::string TableLatex(const Table& table) {
  const TableTexts texts = MakeTexts(table);
  std::string latex = Comments({texts.title, "needs \\usepackage{booktabs}"});
  for (const TextBlock& block : texts.blocks) {
    if (!block.heading.empty()) latex += Comments({block.heading});
    latex += StrCat("\\begin{tabular}{", std::string(texts.text_header.size(), 'l'),
                    std::string(texts.columns.size(), 'r'), "}\n\\toprule\n",
                    Joined(texts.text_header, " & ", LatexEscaped));
    for (const ColumnText& column : texts.columns) latex += " & " + LatexEscaped(column.Heading());
    latex += " \\\\\n\\midrule\n";
    for (const TextLine& line : block.lines) latex += LineLatex(line, AllColumns(texts));
    latex += "\\bottomrule\n\\end{tabular}\n";
  }
  return latex + Comments(texts.footnotes) + Comments(texts.definitions);
}

}  // namespace cvo::reports
