// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/formats/table_latex.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "reports/formats/latex_text.h"
#include "tests/reports/formats/hostile_table.h"
#include "tests/support/temp_folder.h"

namespace cvo::reports {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

bool HasPdflatex() { return std::system("command -v pdflatex > /dev/null") == 0; }

// Returns the output of pdflatex for a document, or nothing if it made a PDF without warnings.
std::string Complaints(const test::TempFolder& folder, const std::string& document) {
  folder.Write("table.tex", document);
  const std::string command = "cd '" + folder.path().string() +
                              "' && HOME=. pdflatex -halt-on-error -interaction=nonstopmode "
                              "-no-shell-escape table.tex > out.txt 2>&1 < /dev/null";
  const int code = std::system(command.c_str());
  const std::string out = test::ReadFile(folder.path() / "out.txt");
  const bool complains = out.find("Overfull") != std::string::npos ||
                         out.find("Warning") != std::string::npos ||
                         out.find("Missing character") != std::string::npos;
  return code != 0 || complains ? out : "";
}

// A table as wide as that of the ablation, with more rows than fit on a page.
Table LargeTable() {
  Table table = test::HostileTable();
  const std::vector<Column> columns = table.columns;
  Row row = table.rows[1];
  while (table.columns.size() < 18) {
    const std::size_t next = table.columns.size() - 4;
    table.columns.push_back(
        {"object_" + std::to_string(next), "object error of a long name", "m", {}});
    row.cells.push_back(test::CellOf(-0.0123, -0.02345, -0.001));
  }
  table.rows.assign(40, row);
  table.others.clear();
  return table;
}

TEST(LatexEscaped, LeavesNoCommands) {
  EXPECT_EQ(LatexEscaped("a_b%c&d#e$f{g}", 99), "a\\_b\\%c\\&d\\#e{\\ttfamily\\char36}f\\{g\\}");
  EXPECT_EQ(LatexEscaped("~^\\", 99), "\\textasciitilde{}\\textasciicircum{}\\textbackslash{}");
  EXPECT_EQ(LatexEscaped("<|>", 99), "\\textless{}\\textbar{}\\textgreater{}");
  EXPECT_EQ(LatexEscaped("a--b", 99), "a-{}-b") << "no dash";
  EXPECT_EQ(LatexEscaped("[a] *", 99), "{}[a] *") << "nothing for the row above";
  EXPECT_EQ(LatexEscaped("caf\xC3\xA9 5\xC2\xB0", 99), "caf\xC3\xA9 5$^\\circ$");
  EXPECT_EQ(LatexEscaped("\xE4\xB8\xAD", 99), "U+4E2D");
}

TEST(LatexEscaped, LetsLongWordsBreak) {
  EXPECT_EQ(LatexEscaped("abcdefgh", 4), "abcd\\allowbreak{}efgh\\allowbreak{}");
  EXPECT_EQ(LatexEscaped("abc_def", 6), "abc\\_\\allowbreak{}def");
  EXPECT_EQ(LatexEscaped("abc def", 6), "abc def");
}

TEST(LatexNumber, HasSigns) {
  EXPECT_EQ(LatexNumber("-0.02..0.01"), "$-$0.02..0.01");
  EXPECT_EQ(LatexNumber("7..71%"), "7..71\\%");
  EXPECT_EQ(LatexNumber("-"), "--");
}

TEST(TableLatex, ShowsValuesIntervalsMarksAndNotes) {
  const std::string latex = TableLatex(test::HostileTable());
  EXPECT_THAT(
      latex,
      AllOf(
          HasSubstr("\\toprule\n"), HasSubstr("\\midrule\n"), HasSubstr("\\bottomrule\n"),
          HasSubstr(" & \\begin{tabular}[t]{@{}r@{}}\\textbf{0.058}\\\\\\scriptsize 0.034..0.085"),
          HasSubstr("0.104\\rlap{\\textsuperscript{*}}"),
          HasSubstr("\\begin{tabular}[b]{@{}r@{}}object ATE\\\\{}[m]\\end{tabular}"),
          HasSubstr("\\relax n, object ATE: "), HasSubstr("bold: best value of the column"),
          HasSubstr("camera ATE: root mean square"), HasSubstr("a caveat: 50 \\%")));
}

TEST(TableLatex, IncomparableReferenceFiguresAreGrey) {
  const std::string latex = TableLatex(test::HostileTable());
  EXPECT_THAT(latex,
              AllOf(HasSubstr("\\textcolor{black!55}{(0.04)}"),
                    HasSubstr("\\textcolor{black!55}{Unknown [a]}"), HasSubstr("Same \\& co [a]"),
                    HasSubstr("\\textbf{0.01}"), HasSubstr("not stated: alignment")));
}

TEST(TableLatexBare, IsTheTableAlone) {
  const std::string latex = TableLatexBare(test::HostileTable());
  EXPECT_THAT(latex, AllOf(Not(HasSubstr("\\documentclass")), Not(HasSubstr("\\end{document}")),
                           HasSubstr("\\toprule"), HasSubstr("booktabs")));
}

// Returns the tabulars of a document, each from its \toprule to its \bottomrule.
std::vector<std::string> Panels(const std::string& latex) {
  std::vector<std::string> panels;
  for (std::size_t at = latex.find("\\toprule"); at != std::string::npos;
       at = latex.find("\\toprule", at + 1)) {
    panels.push_back(latex.substr(at, latex.find("\\bottomrule", at) - at));
  }
  return panels;
}

std::size_t CountOf(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
    ++count;
  }
  return count;
}

TEST(TableLatex, SplitsTablesTooLargeForAPage) {
  const std::vector<std::string> panels = Panels(TableLatex(LargeTable()));
  ASSERT_GE(panels.size(), 6U);
  std::size_t lines = 0;
  for (const std::string& panel : panels) {
    const std::size_t in_panel = 1 + CountOf(panel, "\\addlinespace");
    EXPECT_LE(in_panel, 25U) << "each has an interval below it";
    if (panel.find("ATE") != std::string::npos) lines += in_panel;
  }
  EXPECT_EQ(lines % 40, 0U) << "every row is in one part of the first columns";
}

TEST(TableLatex, PartsLeaveOutRowsWithoutAValue) {
  Table table = test::HostileTable();
  for (int i = 0; i < 4; ++i) {
    table.columns.push_back({"object_more", "object more", "m", {}});
    for (Row& row : table.rows) {
      row.cells.push_back(test::CellOf(0.1, 0.0, 0.2));
      for (ReferenceRow& line : row.reference) line.cells.emplace_back();
    }
  }
  table.others.clear();
  const std::vector<std::string> panels = Panels(TableLatex(table));
  ASSERT_GE(panels.size(), 2U);
  EXPECT_THAT(panels[0], HasSubstr("Same"));
  EXPECT_THAT(panels[1], AllOf(Not(HasSubstr("Same")), HasSubstr("their"))) << "ours alone";
}

TEST(TableLatex, CompilesWithHostileNames) {
  if (!HasPdflatex()) GTEST_SKIP() << "no pdflatex: apt-get install texlive-latex-recommended";
  const test::TempFolder folder;
  Table table = test::HostileTable();
  std::string every;
  for (char32_t c = 1; c < 0x250; ++c) {
    if (c < 0x80) every += static_cast<char>(c);
    if (c >= 0x80)
      every += {static_cast<char>(0xC0 | (c >> 6)), static_cast<char>(0x80 | (c & 63))};
    if (c % 16 == 0) every += ' ';
  }
  table.notes.push_back(every + " \xE4\xB8\xAD\xF0\x9F\x9A\x97");
  table.rows[1].keys = {"[1] \\end{document}", "*\\input{/etc/passwd}--''``,,?`!`"};
  table.others[0].system = "";
  EXPECT_EQ(Complaints(folder, TableLatex(table)), "");
  folder.Write("bare.tex", TableLatexBare(LargeTable()));
  EXPECT_EQ(Complaints(folder,
                       "\\documentclass[a4paper]{article}\\usepackage[margin=15mm]{geometry}\n"
                       "\\usepackage{array,booktabs,graphicx,xcolor}\\begin{document}\n"
                       "\\input{bare}\\end{document}\n"),
            "");
  EXPECT_EQ(Complaints(folder, TableLatex({})), "") << "an empty suite";
}

}  // namespace
}  // namespace cvo::reports
