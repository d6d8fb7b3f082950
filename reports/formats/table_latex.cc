// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/formats/table_latex.h"

#include <algorithm>

#include "core/base/error.h"
#include "core/files/text/utf8.h"
#include "reports/formats/column_panels.h"
#include "reports/formats/latex_text.h"
#include "reports/formats/table_texts.h"

namespace cvo::reports {
namespace {

constexpr std::size_t kWordInColumn = 8;
constexpr std::size_t kWordInProse = 40;
constexpr std::size_t kHeadingCharacters = 12;
constexpr std::size_t kLongText = 24;        // a column of texts wraps above this width
constexpr std::size_t kTextCharacters = 12;  // minimum per wrapped line
constexpr double kNumberColumns = 6.0;       // maximum side by side
constexpr std::size_t kPageLines = 50;

// A part of a block that fits on a page.
struct LatexPanel {
  std::vector<std::size_t> columns;  // indices, never an accuracy without its coverage
  std::vector<std::size_t> lines;    // indices of lines with a value in these columns
};

// Returns which columns of texts wrap, in all blocks alike.
std::vector<bool> WrappedTexts(const TableTexts& texts) {
  std::vector<bool> wrapped(texts.text_header.size(), false);
  for (const TextBlock& block : texts.blocks) {
    for (const TextLine& line : block.lines) {
      for (std::size_t i = 0; i < wrapped.size(); ++i) {
        wrapped[i] = wrapped[i] || Width(line.texts[i]) > kLongText;
      }
    }
  }
  return wrapped;
}

std::size_t PrintedLines(const TextLine& line, const std::vector<bool>& wrapped) {
  std::size_t lines = 1;
  for (std::size_t i = 0; i < wrapped.size(); ++i) {
    if (wrapped[i]) lines = std::max(lines, 1 + Width(line.texts[i]) / kTextCharacters);
  }
  for (const CellText& cell : line.cells) {
    std::size_t below = 0;
    for (const std::string& text : {cell.interval, cell.percent, cell.percent_interval}) {
      below += text.empty() ? 0 : 1;
    }
    lines = std::max(lines, 1 + below);
  }
  return lines;
}

// Splits a block into panels with as many columns, from left to right, and lines, from top to
// bottom, as fit.
std::vector<LatexPanel> SplitBlock(const TableTexts& texts, const TextBlock& block,
                                   const std::vector<bool>& wrapped) {
  const auto parts =
      SplitColumns(texts.columns, std::vector<double>(texts.columns.size(), 1.0), kNumberColumns);
  std::vector<LatexPanel> panels;
  for (std::size_t first = 0, end = 0; first < block.lines.size(); first = end) {
    std::size_t printed = 0;
    for (; end < block.lines.size(); ++end) {
      printed += PrintedLines(block.lines[end], wrapped);
      if (end > first && printed > kPageLines) break;
    }
    for (const auto& part : parts) {
      LatexPanel panel{part, {}};
      for (std::size_t line = first; line < end; ++line) {
        if (part.empty() || HasValue(block.lines[line], part)) panel.lines.push_back(line);
      }
      if (!panel.lines.empty()) panels.push_back(std::move(panel));
    }
  }
  if (panels.empty()) panels.push_back({parts[0], {}});
  return panels;
}

// The contrast of this grey on white is 4.7 to 1.
std::string Grey(const std::string& latex) { return StrCat("\\textcolor{black!55}{", latex, "}"); }

std::string Prose(const std::string& text) { return LatexEscaped(text, kWordInProse); }

// Stacks the lines of one cell directly below each other, however many lines the texts of their row
// take.
std::string Stack(const std::vector<std::string>& lines, const char* position) {
  if (lines.size() == 1) return lines[0];
  std::string latex;
  for (const std::string& line : lines) latex += (latex.empty() ? "" : "\\\\") + line;
  return StrCat("\\begin{tabular}[", position, "]{@{}r@{}}", latex, "\\end{tabular}");
}

// Marks overhang, so that digits stay aligned.
std::string CellLatex(const CellText& cell) {
  std::string value = LatexNumber(cell.Shown());
  if (cell.best) value = StrCat("\\textbf{", value, "}");
  if (cell.distinguishable) value += "\\rlap{\\textsuperscript{*}}";
  std::vector<std::string> lines = {value};
  for (const std::string& text : {cell.interval, cell.percent, cell.percent_interval}) {
    if (!text.empty()) lines.push_back("\\scriptsize " + LatexNumber(text));
  }
  const std::string latex = Stack(lines, "t");
  return cell.grey ? Grey(latex) : latex;
}

// Breaks a heading into short lines: words, then the unit.
std::vector<std::string> HeadingLines(const ColumnText& column) {
  std::vector<std::string> lines;
  std::string rest = column.label;
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find(' '), rest.size());
    const std::string word = rest.substr(0, end);
    if (!lines.empty() && Width(lines.back()) + 1 + Width(word) <= kHeadingCharacters) {
      lines.back() += " " + word;
    } else {
      lines.push_back(word);
    }
    rest.erase(0, end + 1);
  }
  if (!column.unit.empty()) lines.push_back(StrCat("[", column.unit, "]"));
  return lines;
}

std::string HeadingLatex(const ColumnText& column) {
  std::vector<std::string> lines;
  for (const std::string& line : HeadingLines(column)) lines.push_back(Prose(line));
  return lines.empty() ? "" : Stack(lines, "b");
}

// Returns one line of a table: texts at the left, then numbers.
std::string RowLatex(const std::vector<std::string>& cells) {
  std::string latex;
  for (std::size_t i = 0; i < cells.size(); ++i) latex += (i > 0 ? " & " : "") + cells[i];
  return latex + " \\\\\n";
}

std::string LineLatex(const TextLine& line, const LatexPanel& panel) {
  std::vector<std::string> cells;
  for (const std::string& text : line.texts) {
    const std::string latex = LatexEscaped(text, kWordInColumn);
    cells.push_back(line.grey && !text.empty() ? Grey(latex) : latex);
  }
  for (const std::size_t column : panel.columns) cells.push_back(CellLatex(line.cells[column]));
  return RowLatex(cells);
}

std::string PanelLatex(const TableTexts& texts, const TextBlock& block, const LatexPanel& panel,
                       const std::vector<bool>& wrapped) {
  std::string kinds;
  std::vector<std::string> header;
  for (std::size_t i = 0; i < wrapped.size(); ++i) {
    kinds += wrapped[i] ? ">{\\raggedright\\arraybackslash}p{10em}" : "l";
    header.push_back(LatexEscaped(texts.text_header[i], kWordInColumn));
  }
  for (const std::size_t column : panel.columns) {
    kinds += "r";
    header.push_back(HeadingLatex(texts.columns[column]));
  }
  std::string latex = StrCat("\\sbox0{\\begin{tabular}{@{}", kinds, "@{}}\n\\toprule\n",
                             RowLatex(header), "\\midrule\n");
  for (const std::size_t line : panel.lines) {
    if (line != panel.lines.front()) latex += "\\addlinespace[2pt]\n";
    latex += LineLatex(block.lines[line], panel);
  }
  return latex +
         "\\bottomrule\n\\end{tabular}}\n\\noindent\\ifdim\\wd0>\\linewidth"
         "\\resizebox{\\linewidth}{!}{\\usebox0}\\else\\usebox0\\fi\\par\\medskip\n";
}

std::string BlockLatex(const TableTexts& texts, const TextBlock& block,
                       const std::vector<bool>& wrapped) {
  std::string latex;
  if (!block.heading.empty()) {
    latex += StrCat("\\noindent ", Prose(block.heading), ":\\par\\smallskip\n");
  }
  const std::vector<LatexPanel> panels = SplitBlock(texts, block, wrapped);
  for (std::size_t i = 0; i < panels.size(); ++i) {
    if (panels.size() > 1) {
      latex += StrCat("\\noindent part ", i + 1, " of ", panels.size(), "\\par\\nobreak\n");
    }
    latex += PanelLatex(texts, block, panels[i], wrapped);
  }
  return latex;
}

std::string ListLatex(const std::vector<std::string>& notes) {
  std::string latex;
  for (const std::string& note : notes) {
    latex += StrCat("\\noindent\\hangindent=1em\\relax ", Prose(note), "\\par\n");
  }
  return latex;
}

std::string NotesLatex(const TableTexts& texts) {
  std::string latex;
  if (texts.any_best) latex += ListLatex({BestNote("bold")});
  latex += ListLatex(texts.footnotes);
  if (texts.definitions.empty()) return latex;
  return latex + "\\smallskip\\noindent What the columns are:\\par\n" +
         ListLatex(texts.definitions);
}

std::string BodyLatex(const TableTexts& texts) {
  const std::vector<bool> wrapped = WrappedTexts(texts);
  std::string latex = "\\begingroup\\footnotesize\\setlength{\\tabcolsep}{4pt}\n";
  for (const TextBlock& block : texts.blocks) latex += BlockLatex(texts, block, wrapped);
  return latex + "\\raggedright\n" + NotesLatex(texts) + "\\endgroup\n";
}

}  // namespace

std::string TableLatex(const Table& table) {
  const TableTexts texts = MakeTexts(table);
  std::string latex =
      "\\documentclass[a4paper]{article}\n\\usepackage[margin=15mm]{geometry}\n"
      "\\usepackage{array,booktabs,graphicx,xcolor}\n\\pagestyle{empty}\n\\begin{document}\n";
  if (!texts.title.empty()) {
    latex += StrCat("\\noindent\\textbf{", Prose(texts.title), "}\\par\n");
  }
  if (!texts.about.empty()) latex += StrCat("\\noindent ", Prose(texts.about), "\\par\n");
  return latex + "\\medskip\n" + BodyLatex(texts) + "\\end{document}\n";
}

std::string TableLatexBare(const Table& table) {
  const TableTexts texts = MakeTexts(table);
  return StrCat("% ", texts.title, "\n% needs \\usepackage{array,booktabs,graphicx,xcolor}\n",
                BodyLatex(texts));
}

}  // namespace cvo::reports
