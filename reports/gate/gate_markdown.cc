// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <cctype>

#include "core/base/error.h"
#include "core/files/text/escape.h"
#include "core/files/text/utf8.h"
#include "reports/gate/gate_text.h"

namespace cvo::reports {
namespace {

std::string EscapedCell(const std::string& text) { return MarkdownEscaped(Printable(text)); }

std::string Line(const std::vector<std::string>& row) {
  std::string line = "|";
  for (const std::string& cell : row) line += StrCat(" ", EscapedCell(cell), " |");
  return line + "\n";
}

std::string MarkdownTable(const TextRows& rows) {
  if (rows.empty()) return "";
  std::string text = StrCat("\n", Line(rows.front()));
  text += Line(std::vector<std::string>(rows.front().size(), "---"));
  for (std::size_t i = 1; i < rows.size(); ++i) text += Line(rows[i]);
  return text;
}

std::string MarkdownList(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) {
    text += StrCat(text.empty() ? "\n- " : "- ", EscapedCell(line), "\n");
  }
  return text;
}

}  // namespace

std::string GateMarkdown(const GateReport& report) {
  std::string verdict = GateVerdict(report);
  verdict.front() = static_cast<char>(std::toupper(verdict.front()));
  return StrCat("### ", verdict, "\n\n", EscapedCell(Headline(report)), "\n",
                MarkdownTable(MovedRows(report)), MarkdownList(ProblemLines(report)),
                MarkdownTable(TimeRows(report)), MarkdownList(NoteLines(report)));
}

}  // namespace cvo::reports
