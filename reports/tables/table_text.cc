// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <string_view>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "core/files/text/utf8.h"
#include "reports/tables/table_texts.h"

namespace cvo::reports {
namespace {

using Cells = std::vector<std::string>;

// What fits on one screen.
constexpr std::size_t kWidth = 100;
constexpr std::size_t kRows = 31;  // of 40 lines, without title, headings, notes and empty lines
constexpr std::size_t kColumns = 6;
constexpr std::size_t kLeastLabel = 24;

// One column of the short table: a metric, or two whose values share a cell.
struct ShortColumn {
  std::vector<std::size_t> columns;  // of the table
  std::array<std::string, 2> heading;
  std::size_t width = 0;
};

std::string Shortened(std::string text, std::size_t width) {
  if (Width(text) <= width) return text;
  while (Width(text) >= width) text.pop_back();
  return text + "~";
}

// Splits a heading into two lines, as narrow as possible.
std::array<std::string, 2> TwoLines(const std::string& text) {
  std::array<std::string, 2> best = {"", text};
  for (std::size_t at = text.find(' '); at != std::string::npos; at = text.find(' ', at + 1)) {
    const std::array<std::string, 2> lines = {text.substr(0, at), text.substr(at + 1)};
    if (std::max(Width(lines[0]), Width(lines[1])) < std::max(Width(best[0]), Width(best[1]))) {
      best = lines;
    }
  }
  return best;
}

// The columns that tell most, then those that the table begins with.
std::vector<ShortColumn> ShortColumns(const Table& table, const TableTexts& texts) {
  std::vector<std::vector<std::size_t>> picked;
  std::vector<std::size_t> used;
  const auto index_of = [&](const char* metric) {
    const Column* column = FindBy(table.columns, &Column::metric, metric);
    return static_cast<std::size_t>(column == nullptr ? -1 : column - table.columns.data());
  };
  for (const auto& [first, second] : {std::pair{"object_success_10cm", ""},
                                      {"object_ate", ""},
                                      {"object_coverage", ""},
                                      {"object_id_switches", ""},
                                      {"moving_precision", "moving_recall"},
                                      {"camera_ate", ""}}) {
    std::vector<std::size_t> columns;
    for (const std::size_t index : {index_of(first), index_of(second)}) {
      if (index < table.columns.size()) columns.push_back(index);
    }
    used.insert(used.end(), columns.begin(), columns.end());
    if (!columns.empty()) picked.push_back(columns);
  }
  for (std::size_t i = 0; i < table.columns.size() && picked.size() < kColumns; ++i) {
    if (std::find(used.begin(), used.end(), i) == used.end()) picked.push_back({i});
  }
  std::vector<ShortColumn> columns;
  for (const std::vector<std::size_t>& of : picked) {
    columns.push_back({of, TwoLines(of.size() == 2 ? "moving prec./recall"
                                                   : texts.columns[of.front()].Heading())});
  }
  return columns;
}

// The value, or two with a slash; with a star if one is distinguishable from the reference.
std::string ShortCell(const TextLine& line, const ShortColumn& column) {
  std::string text;
  std::string mark = " ";
  for (const std::size_t i : column.columns) {
    const std::string shown = line.cells[i].Shown();
    if (!shown.empty()) text += (text.empty() ? "" : "/") + shown;
    if (line.cells[i].distinguishable) mark = "*";
    if (line.cells[i].grey) mark.clear();
  }
  return text.empty() ? "" : text + mark;
}

// The values of the keys of a row, options with the last part of their name; the name of a system.
std::string ShortLabel(const Table& table, const TextLine& line) {
  Cells parts;
  for (std::size_t i = 0; i < table.keys.size(); ++i) {
    const std::string& value = line.texts[i];
    const std::size_t dot = table.keys[i].rfind('.');
    if (dot == std::string::npos || line.theirs != nullptr) {
      if (!value.empty()) parts.push_back(value);
    } else if (value != "default") {
      parts.push_back(StrCat(table.keys[i].substr(dot + 1), "=", value));
    }
  }
  if (line.theirs != nullptr) return "  " + Joined(parts, " ");
  const JobCounts& jobs = line.row->jobs;
  if (jobs.done < jobs.planned) parts.push_back(StrCat("(", jobs.done, "/", jobs.planned, ")"));
  return Joined(parts, " ");
}

// Three lines at most: what ran, what a reader must know, and where the rest is.
Cells ShortNotes(const Table& table, const TableTexts& texts) {
  std::size_t scenes = 0;
  for (const Row& row : table.rows) {
    for (const Cell& cell : row.cells) scenes = std::max(scenes, cell.n.scenes);
  }
  Cells notes = {StrCat(JobsText(table.jobs), ", ", Counted(scenes, "scene"), " a row")};
  const auto has = [&](const auto& is) {
    return std::any_of(texts.blocks[0].lines.begin(), texts.blocks[0].lines.end(),
                       [&](const TextLine& line) {
                         return std::any_of(line.cells.begin(), line.cells.end(), is);
                       });
  };
  if (has([](const CellText& cell) { return cell.distinguishable; })) {
    notes[0] += "; *: differs from " + Printable(table.reference) + " by more than noise";
  }
  if (has([](const CellText& cell) { return cell.grey; })) notes[0] += "; (..): not comparable";
  Cells remarks = ProblemTexts(table);
  remarks.insert(remarks.end(), table.notes.begin(), table.notes.end());
  if (remarks.size() > 1) {
    const std::string more = StrCat(" (and ", remarks.size() - 1, " more)");
    remarks = {Shortened(Printable(remarks.front()), kWidth - more.size()) + more};
  }
  notes.insert(notes.end(), remarks.begin(), remarks.end());
  notes.emplace_back("all columns, intervals, differences and notes: --all");
  for (std::string& note : notes) note = Shortened(Printable(note), kWidth);
  return notes;
}

std::string Padded(const std::string& text, std::size_t width) {
  return std::string(width - std::min(width, Width(text)), ' ') + text;
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

std::string LatexCell(const CellText& cell) {
  return LatexNumber(cell.Shown()) + (cell.distinguishable ? "\\rlap{$^{*}$}" : "");
}

// A row of values and, as far as some cell has one, rows of intervals and of percentages.
std::string LineLatex(const TextLine& line) {
  Cells cells;
  for (const std::string& text : line.texts) cells.push_back(LatexEscaped(text));
  for (const CellText& cell : line.cells) cells.push_back(LatexCell(cell));
  std::string latex = Joined(cells, " & ") + " \\\\\n";
  for (const auto part : {&CellText::interval, &CellText::percent}) {
    cells.assign(line.texts.size(), "");
    bool any = false;
    for (const CellText& cell : line.cells) {
      const std::string number = LatexNumber(cell.*part);
      any = any || !number.empty();
      cells.push_back(number.empty() ? "" : StrCat("{\\scriptsize ", number, "}"));
    }
    if (any) latex += Joined(cells, " & ") + " \\\\\n";
  }
  return latex;
}

std::string Comments(const std::vector<std::string>& lines) {
  std::string latex;
  for (const std::string& line : lines) latex += StrCat("% ", line, "\n");
  return latex;
}

}  // namespace

std::string AlignedText(const std::vector<Cells>& rows) {
  std::vector<std::size_t> widths(rows.empty() ? 0 : rows.front().size());
  for (const Cells& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      widths[i] = std::max(widths[i], Width(Printable(row[i])));
    }
  }
  std::string text;
  for (const Cells& row : rows) {
    std::string line;
    for (std::size_t i = 0; i < row.size(); ++i) {
      const std::string cell = Printable(row[i]);
      line += cell + std::string(widths[i] + 2 - Width(cell), ' ');
    }
    text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
  }
  return text;
}

std::string TableText(const Table& table) {
  const TableTexts texts = MakeTexts(table);
  std::vector<ShortColumn> columns = ShortColumns(table, texts);
  std::vector<const TextLine*> lines;
  for (const TextLine& line : texts.blocks[0].lines) lines.push_back(&line);
  if (lines.size() > kRows) {
    std::erase_if(lines, [](const TextLine* line) { return line->theirs != nullptr; });
  }
  const std::size_t more = lines.size() > kRows ? lines.size() - kRows + 1 : 0;
  lines.resize(lines.size() - more);
  std::size_t right = 0;
  for (ShortColumn& column : columns) {
    column.width = std::max(Width(column.heading[0]), Width(column.heading[1])) + 1;
    for (const TextLine* line : lines) {
      column.width = std::max(column.width, Width(ShortCell(*line, column)));
    }
    right += column.width + 1;
  }
  while (columns.size() > 1 && right + kLeastLabel > kWidth) {
    right -= columns.back().width + 1;
    columns.pop_back();
  }
  std::size_t label = 0;
  for (const TextLine* line : lines) label = std::max(label, Width(ShortLabel(table, *line)));
  label = std::min(label, kWidth - right);
  const std::string title =
      StrCat(texts.title, texts.title.empty() || texts.about.empty() ? "" : ": ", texts.about);
  std::string text = title.empty() ? "" : Shortened(title, kWidth) + "\n\n";
  const auto add = [&](const std::string& name, const auto& cell_of) {
    std::string line = name + std::string(label - Width(name), ' ');
    for (const ShortColumn& column : columns) line += " " + Padded(cell_of(column), column.width);
    text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
  };
  for (const std::size_t at : {0U, 1U}) {
    add("", [&](const ShortColumn& column) { return column.heading.at(at) + " "; });
  }
  for (const TextLine* line : lines) {
    add(Shortened(ShortLabel(table, *line), label),
        [&](const ShortColumn& column) { return ShortCell(*line, column); });
  }
  if (more > 0) text += StrCat("and ", more, " more rows\n");
  return text + "\n" + Joined(ShortNotes(table, texts), "\n") + "\n";
}

std::string TableListing(const Table& table) {
  const TableTexts texts = MakeTexts(table);
  std::string text = texts.title.empty() ? "" : texts.title + "\n";
  if (!texts.about.empty()) text += texts.about + "\n";
  for (const TextBlock& block : texts.blocks) {
    if (!block.heading.empty()) text += "\n" + block.heading + "\n";
    for (const TextLine& line : block.lines) {
      std::vector<Cells> rows;
      for (std::size_t i = 0; i < line.cells.size(); ++i) {
        const CellText& cell = line.cells[i];
        if (cell.value.empty()) continue;
        rows.push_back({"  " + texts.columns[i].Heading(),
                        cell.Shown() + (cell.distinguishable ? "*" : ""), cell.interval,
                        cell.percent});
      }
      if (rows.empty()) continue;
      Cells names = line.texts;
      std::erase(names, "");
      text += StrCat("\n", Joined(names, "  "), "\n", AlignedText(rows));
    }
  }
  return StrCat(text, "\n", Joined(texts.footnotes, "\n"), "\n");
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
    for (const TextLine& line : block.lines) latex += LineLatex(line);
    latex += "\\bottomrule\n\\end{tabular}\n";
  }
  return latex + Comments(texts.footnotes) + Comments(texts.definitions);
}

}  // namespace cvo::reports
