// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <numeric>
#include <string_view>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "core/files/text/utf8.h"
#include "core/record/suite_runs.h"
#include "reports/tables/table_texts.h"

namespace cvo::reports {
namespace {

using Cells = std::vector<std::string>;

// What fits on one screen.
constexpr std::size_t kWidth = 100;
constexpr std::size_t kRows = 31;  // of 40 lines, without title, headings, notes and empty lines
constexpr std::size_t kColumns = 6;
constexpr std::size_t kLeastLabel = 24;

std::string Shortened(std::string text, std::size_t width) {
  if (Width(text) <= width) return text;
  while (Width(text) >= width) text.pop_back();
  return text + "~";
}

// The name of a row without its middle: options are at the begin, variants at the end.
std::string ShortenedName(const std::string& text, std::size_t width) {
  constexpr std::size_t kBegin = 10;
  if (Width(text) <= width) return text;
  const std::string begin = Shortened(text, kBegin);
  std::string end = text;
  const auto continues = [&] { return (static_cast<unsigned char>(end[0]) & 0xC0U) == 0x80U; };
  while (Width(begin) + Width(end) > width || continues()) end.erase(0, 1);
  return begin + end;
}

bool IsAbsent(const TextLine& line) {
  return line.row != nullptr && line.row->jobs.no_data > 0 &&
         line.row->jobs.no_data == line.row->jobs.planned;
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

// The value, or two with a slash unless both are missing; with a star if one is distinguishable
// from the reference.
std::string ShortCell(const TextLine& line, const std::vector<std::size_t>& columns) {
  std::string text;
  std::string mark = " ";
  for (const std::size_t i : columns) {
    const std::string shown = line.cells[i].Shown();
    if (!shown.empty()) text += (text.empty() ? "" : "/") + shown;
    if (line.cells[i].distinguishable) mark = "*";
    if (line.cells[i].grey) mark.clear();
  }
  if (text == "-/-") text = "-";
  return text.empty() ? "" : text + mark;
}

// The values of the keys of a row, options with the last part of their name; the name of a system.
// If that is long, options that most rows have are left out, unless a row has no others.
std::string ShortLabel(const Table& table, const std::vector<const TextLine*>& lines,
                       const TextLine& line) {
  constexpr std::size_t kLong = 40;
  Cells parts, unusual;
  bool differs = false;
  for (std::size_t i = 0; i < table.keys.size(); ++i) {
    const std::string& value = line.texts[i];
    const std::size_t dot = table.keys[i].rfind('.');
    const bool is_option = dot != std::string::npos && line.theirs == nullptr;
    if (is_option ? value == "default" : value.empty()) continue;
    parts.push_back(is_option ? StrCat(table.keys[i].substr(dot + 1), "=", value) : value);
    const auto same =
        std::ranges::count(lines, value, [&](auto* other) { return other->texts[i]; });
    if (is_option && 2 * same > std::ssize(lines)) continue;
    unusual.push_back(parts.back());
    differs = differs || is_option;
  }
  if (differs && Width(Joined(parts, " ")) > kLong) parts = unusual;
  if (line.theirs != nullptr) return "  " + Joined(parts, " ");
  const JobCounts& jobs = line.row->jobs;
  if (jobs.done < jobs.planned) parts.push_back(StrCat("(", jobs.done, "/", jobs.planned, ")"));
  return Joined(parts, " ");
}

// Two lines at most: what ran, and what a reader must know.
Cells ShortNotes(const Table& table, const TableTexts& texts) {
  std::size_t scenes = 0;
  bool stars = false;
  bool grey = false;
  for (const Row& row : table.rows) {
    for (const Cell& cell : row.cells) scenes = std::max(scenes, cell.n.scenes);
  }
  for (const TextLine& line : texts.blocks[0].lines) {
    for (const CellText& cell : line.cells) {
      stars = stars || cell.distinguishable;
      grey = grey || cell.grey;
    }
  }
  Cells notes = {StrCat(JobsText(table.jobs), ", ", Counted(scenes, "scene"), " a row",
                        stars ? "; *: differs from " + table.reference + " by more than noise" : "",
                        grey ? "; (..): not comparable" : "")};
  Cells remarks = ProblemTexts(table);
  remarks.insert(remarks.end(), table.notes.begin(), table.notes.end());
  if (remarks.size() > 1) {
    const std::string more = StrCat(" (and ", remarks.size() - 1, " more)");
    remarks = {Shortened(Printable(remarks.front()), kWidth - more.size()) + more};
  }
  notes.insert(notes.end(), remarks.begin(), remarks.end());
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
  return cell.grey ? "*" + text + "*" : text;
}

// Of the first `keys` texts and the cells of `columns`.
std::string LineMarkdown(const TextLine& line, std::size_t keys,
                         const std::vector<std::size_t>& columns) {
  Cells cells;
  for (std::size_t i = 0; i < keys; ++i) {
    const std::string escaped = MarkdownEscaped(line.texts[i]);
    cells.push_back(line.grey && !line.texts[i].empty() ? "*" + escaped + "*" : escaped);
  }
  for (const std::size_t i : columns) cells.push_back(CellMarkdown(line.cells[i]));
  return "| " + Joined(cells, " | ") + " |\n";
}

std::string BlockMarkdown(const TableTexts& texts, const TextBlock& block, std::size_t keys,
                          const std::vector<std::size_t>& columns) {
  Cells header(texts.text_header.begin(),
               texts.text_header.begin() + static_cast<std::ptrdiff_t>(keys));
  for (const std::size_t i : columns) header.push_back(texts.columns[i]);
  std::string text = StrCat("| ", Joined(header, " | ", MarkdownEscaped), " |\n|");
  for (std::size_t i = 0; i < header.size(); ++i) text += i < keys ? "---|" : "---:|";
  text += "\n";
  for (const TextLine& line : block.lines) {
    if (!IsAbsent(line)) text += LineMarkdown(line, keys, columns);
  }
  return text + "\n";
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

// With proper minus signs.
std::string LatexCell(const CellText& cell) {
  if (cell.value == "-") return "--";
  std::string text;
  for (const char c : cell.Shown()) text += c == '-' ? "$-$" : std::string(1, c);
  return text + (cell.distinguishable ? "\\rlap{$^{*}$}" : "");
}

}  // namespace

std::vector<std::size_t> KeyColumns(const Table& table) {
  std::vector<std::size_t> key;
  for (const char* metric :
       {kFrameCpu, "object_success_10cm", "object_ate", "object_coverage", "object_id_switches",
        "moving_precision", "moving_recall", "camera_ate"}) {
    const Column* column = FindBy(table.columns, &Column::metric, metric);
    if (column) key.push_back(static_cast<std::size_t>(column - table.columns.data()));
  }
  for (std::size_t i = 0; i < table.columns.size() && key.size() <= kColumns; ++i) AddOnce(i, key);
  return key;
}

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

ShortTable MakeShortTable(const Table& table) {
  const TableTexts texts = MakeTexts(table);
  ShortTable made;
  std::vector<std::vector<std::size_t>> columns;  // of the table; precision and recall share one
  for (const std::size_t i : KeyColumns(table)) {
    if (table.columns[i].metric == "moving_recall" && !columns.empty() &&
        table.columns[columns.back().front()].metric == "moving_precision") {
      columns.back().push_back(i);
      made.headings.back() = "moving prec./recall";
    } else if (columns.size() < kColumns) {
      columns.push_back({i});
      made.headings.push_back(texts.columns[i]);
    }
  }
  std::vector<const TextLine*> lines;
  for (const TextLine& line : texts.blocks[0].lines) {
    if (!IsAbsent(line)) lines.push_back(&line);
  }
  if (lines.size() > kRows) {
    std::erase_if(lines, [](const TextLine* line) { return line->theirs != nullptr; });
  }
  made.more = lines.size() > kRows ? lines.size() - kRows + 1 : 0;
  lines.resize(lines.size() - made.more);
  for (const TextLine* line : lines) {
    Cells& row = made.rows.emplace_back();
    row.push_back(ShortLabel(table, lines, *line));
    for (const auto& of : columns) row.push_back(ShortCell(*line, of));
  }
  made.notes = ShortNotes(table, texts);
  return made;
}

std::string TableText(const Table& table) {
  ShortTable texts = MakeShortTable(table);
  std::vector<std::array<std::string, 2>> headings;
  std::vector<std::size_t> widths = {0};  // of the label, then of each column
  for (const Cells& row : texts.rows) widths[0] = std::max(widths[0], Width(row[0]));
  std::size_t right = 0;
  for (std::size_t i = 0; i < texts.headings.size(); ++i) {
    headings.push_back(TwoLines(texts.headings[i]));
    std::size_t width = std::max(Width(headings[i][0]), Width(headings[i][1])) + 1;
    for (const Cells& row : texts.rows) width = std::max(width, Width(row[i + 1]));
    if (i > 0 && right + width + 1 + kLeastLabel > kWidth) break;
    widths.push_back(width);
    right += width + 1;
  }
  widths[0] = std::min(widths[0], kWidth - right);
  const std::string title =
      StrCat(Printable(table.title), table.title.empty() || table.about.empty() ? "" : ": ",
             Printable(table.about));
  std::string text = title.empty() ? "" : Shortened(title, kWidth) + "\n\n";
  const auto add = [&](const std::string& label, const auto& cell_of) {
    std::string line = label + std::string(widths[0] - Width(label), ' ');
    for (std::size_t i = 1; i < widths.size(); ++i) {
      line += " " + Padded(cell_of(i - 1), widths[i]);
    }
    text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
  };
  for (const std::size_t at : {0U, 1U}) {
    add("", [&](std::size_t i) { return headings[i].at(at) + " "; });
  }
  for (const Cells& row : texts.rows) {
    add(ShortenedName(row[0], widths[0]), [&](std::size_t i) { return row[i + 1]; });
  }
  if (texts.more > 0) text += StrCat("and ", texts.more, " more rows\n");
  return StrCat(text, "\n", Joined(texts.notes, "\n"),
                "\nall columns, intervals, differences and notes: --all\n");
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
        rows.push_back({"  " + texts.columns[i], cell.Shown() + (cell.distinguishable ? "*" : ""),
                        cell.interval, cell.percent});
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
  std::vector<std::size_t> columns(texts.columns.size());
  std::iota(columns.begin(), columns.end(), 0U);
  for (const TextBlock& block : texts.blocks) {
    if (!block.heading.empty()) text += MarkdownEscaped(block.heading) + ":\n\n";
    text += BlockMarkdown(texts, block, texts.text_header.size(), columns);
  }
  for (const std::string& note : texts.footnotes) text += "- " + MarkdownEscaped(note) + "\n";
  return text;
}

std::string ShortMarkdown(const Table& table) {
  const TableTexts texts = MakeTexts(table);
  std::string text = texts.about.empty() ? "" : Paragraph(texts.about) + "\n\n";
  text += BlockMarkdown(texts, texts.blocks[0], table.keys.size(), KeyColumns(table));
  Table noted = table;  // without the folder that a sequence was not found in
  std::erase_if(noted.problems, [](const Problem& problem) { return problem.state == "no data"; });
  for (const std::string& note : ShortNotes(noted, texts)) text += MarkdownEscaped(note) + "; ";
  for (const std::string& build : table.provenance.builds) text += "build " + build.substr(0, 12);
  return text + "\n";
}

std::string TableLatex(const Table& table) {
  const TableTexts texts = MakeTexts(table);
  std::string latex =
      StrCat("% ", texts.title, "\n% needs \\usepackage{booktabs}\n\\begin{tabular}{",
             std::string(texts.text_header.size(), 'l'), std::string(texts.columns.size(), 'r'),
             "}\n\\toprule\n", Joined(texts.text_header, " & ", LatexEscaped), " & ",
             Joined(texts.columns, " & ", LatexEscaped), " \\\\\n\\midrule\n");
  for (const TextLine& line : texts.blocks[0].lines) {
    latex += StrCat(Joined(line.texts, " & ", LatexEscaped), " & ",
                    Joined(line.cells, " & ", LatexCell), " \\\\\n");
  }
  return latex + "\\bottomrule\n\\end{tabular}\n% " + Joined(texts.footnotes, "\n% ") + "\n";
}

}  // namespace cvo::reports
