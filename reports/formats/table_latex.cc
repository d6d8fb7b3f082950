// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/formats/table_latex.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "reports/formats/latex_panels.h"
#include "reports/formats/latex_text.h"
#include "reports/formats/table_texts.h"

namespace cvo::reports {
namespace {

constexpr std::size_t kWordInColumn = 8;
constexpr std::size_t kWordInProse = 40;

// The contrast of this grey on white is 4.7 to 1.
std::string Grey(const std::string& latex) { return StrCat("\\textcolor{black!55}{", latex, "}"); }

std::string Prose(const std::string& text) { return LatexEscaped(text, kWordInProse); }

// Lines of one cell, right below each other however many lines the texts of their row take.
std::string Stack(const std::vector<std::string>& lines, const char* position) {
  if (lines.size() == 1) return lines[0];
  std::string latex;
  for (const std::string& line : lines) latex += (latex.empty() ? "" : "\\\\") + line;
  return StrCat("\\begin{tabular}[", position, "]{@{}r@{}}", latex, "\\end{tabular}");
}

// Marks hang over: digits stay below digits.
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

std::string HeadingLatex(const ColumnText& column) {
  std::vector<std::string> lines;
  for (const std::string& line : HeadingLines(column)) lines.push_back(Prose(line));
  return lines.empty() ? "" : Stack(lines, "b");
}

// A line of a table: texts at the left, then numbers.
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
                       const std::vector<LatexColumn>& columns) {
  std::string kinds;
  std::vector<std::string> header;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    kinds += columns[i].wraps ? StrCat(">{\\raggedright\\arraybackslash}p{",
                                       std::lround(columns[i].width_pt), "pt}")
                              : "l";
    header.push_back(Prose(texts.text_header[i]));
  }
  for (const std::size_t column : panel.columns) {
    kinds += "r";
    header.push_back(HeadingLatex(texts.columns[column]));
  }
  std::string latex = StrCat("\\noindent\\begin{tabular}{@{}", kinds, "@{}}\n\\toprule\n",
                             RowLatex(header), "\\midrule\n");
  for (const std::size_t line : panel.lines) {
    if (line != panel.lines.front()) latex += "\\addlinespace[2pt]\n";
    latex += LineLatex(block.lines[line], panel);
  }
  return latex + "\\bottomrule\n\\end{tabular}\\par\\medskip\n";
}

std::string BlockLatex(const TableTexts& texts, const TextBlock& block,
                       const std::vector<LatexColumn>& columns) {
  std::string latex;
  if (!block.heading.empty()) {
    latex += StrCat("\\noindent ", Prose(block.heading), ":\\par\\smallskip\n");
  }
  const std::vector<LatexPanel> panels = SplitBlock(texts, block, columns);
  for (std::size_t i = 0; i < panels.size(); ++i) {
    if (panels.size() > 1) {
      latex += StrCat("\\noindent part ", i + 1, " of ", panels.size(), "\\par\\nobreak\n");
    }
    latex += PanelLatex(texts, block, panels[i], columns);
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
  const std::vector<LatexColumn> columns = MeasureTexts(texts);
  std::string latex =
      StrCat("\\begingroup\\footnotesize\\setlength{\\tabcolsep}{", 0.5 * kColumnGap_pt, "pt}\n");
  for (const TextBlock& block : texts.blocks) latex += BlockLatex(texts, block, columns);
  return latex + "\\raggedright\n" + NotesLatex(texts) + "\\endgroup\n";
}

}  // namespace

std::string TableLatex(const Table& table) {
  const TableTexts texts = MakeTexts(table);
  std::string latex =
      "\\documentclass[a4paper]{article}\n\\usepackage[margin=15mm]{geometry}\n"
      "\\usepackage{array,booktabs,xcolor}\n\\pagestyle{empty}\n\\begin{document}\n";
  if (!texts.title.empty()) {
    latex += StrCat("\\noindent\\textbf{", Prose(texts.title), "}\\par\n");
  }
  if (!texts.about.empty()) latex += StrCat("\\noindent ", Prose(texts.about), "\\par\n");
  return latex + "\\medskip\n" + BodyLatex(texts) + "\\end{document}\n";
}

std::string TableLatexBare(const Table& table) {
  const TableTexts texts = MakeTexts(table);
  return StrCat("% ", texts.title, "\n% needs \\usepackage{array,booktabs,xcolor}; at most ",
                kPanelWidth_pt, " pt wide\n", BodyLatex(texts));
}

}  // namespace cvo::reports
